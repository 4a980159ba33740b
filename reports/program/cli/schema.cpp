// pmreport schema [MECHANISM]: what a scenario may hold, as JSON Schema, for editors that complete and check while one writes.
#include <core/mechanics/machine/machine.hpp>
#include <core/text/units.hpp>
#include <reports/program/cli/parameter_words.hpp>
#include <reports/program/cli/scenario_shape.hpp>
#include <reports/program/cli/shape_json.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>
#include <reports/section/kinds.hpp>

#include <fmt/format.h>

namespace pmreport::program {

using mechanics::Machine, mechanics::MechanismInfo, mechanics::ParameterInfo;
using scenario::Shape;

namespace {

Json json_of_parameter(const ParameterInfo& p) {
  Json out;
  if (p.kind == PM_CHOICE) {
    out = {{"enum", p.choices}};
  } else {
    const Shape one = Shape::quantity(parse_unit(p.unit).value_or(Unit{}).dimension);
    out = json_of(p.kind == PM_NUMBER ? one : Shape::list(p.count_min, p.count_max, one), {});
    if (p.kind == PM_NUMBER && p.unit.empty()) out["minimum"] = p.min, out["maximum"] = p.max;
  }
  out["description"] = fmt::format("{}; {}, {}{}", p.title, range_in_words(p), default_in_toml(p), " if left out");
  if (!p.unless.empty()) out["description"] = fmt::format("{}; not beside {}", out["description"].get<std::string>(), p.unless);
  // TOML writes these values as JSON does.
  out["default"] = Json::parse(default_in_toml(p));
  return out;
}

Json json_of_parameters(const MechanismInfo& info) {
  Json properties = Json::object();
  for (const ParameterInfo& p : info.parameters) properties[p.name] = json_of_parameter(p);
  return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

std::string definition_of(const scenario::SectionKind& kind) { return "section_" + kind.name; }

// What stands in a section, by its kind. Editors complete what is listed in one place, so all keys are; the kind then tells which fit.
Json json_of_sections(const NamesByKind& names, Json& definitions) {
  Json kinds = Json::array(), rules = Json::array(), all = Json::object();
  for (const scenario::SectionKind* kind : section::kinds()) {
    Json own = json_of_keys(kind->keys, names);
    for (const auto& [key, value] : own["properties"].items()) {
      const std::string words = value.value("description", "");
      std::string told = all.contains(key) ? all[key]["description"].get<std::string>() + "\n" : std::string();
      all[key] = {{"description", told + fmt::format("{}: {}", kind->name, words)}};
    }
    own["properties"]["kind"] = {{"const", kind->name}, {"description", kind->purpose}};
    own["properties"]["title"] = {{"type", "string"}};
    definitions[definition_of(*kind)] = std::move(own);
    kinds.push_back(kind->name);
    rules.push_back({{"if", {{"properties", {{"kind", {{"const", kind->name}}}}}, {"required", {"kind"}}}},
                     {"then", {{"$ref", "#/$defs/" + definition_of(*kind)}}}});
  }
  Json properties{{"kind", {{"enum", std::move(kinds)}, {"description", "what the section shows"}}},
                  {"title", {{"type", "string"}, {"description", "in place of the kind's own"}}}};
  properties.update(all);
  return {{"type", "array"},
          {"items", {{"type", "object"}, {"properties", std::move(properties)}, {"required", {"kind"}}, {"allOf", std::move(rules)}}}};
}

NamesByKind names_of(const MechanismInfo& info, const Topology& t) {
  NamesByKind out;
  for (const Coordinate& c : t.coordinates) out["coordinates"].push_back(c.name);
  for (const Actuator& a : t.actuators) out["actuators"].push_back(a.name);
  for (const Joint& j : t.joints) out["joints"].push_back(j.name);
  for (const ParameterInfo& p : info.parameters) out["parameters"].push_back(p.name);
  return out;
}

Json whole(const std::string& title, const Shape& shape, const NamesByKind& names, Json mechanism, Json parameters) {
  Json out{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  Json definitions = Json::object();
  out.update(json_of(shape, names));
  Json& properties = out["properties"];
  properties["mechanism"]["properties"]["use"] = std::move(mechanism);
  properties["mechanism"]["properties"]["parameters"] = std::move(parameters);
  properties["section"] = json_of_sections(names, definitions);
  out["$defs"] = std::move(definitions);
  return out;
}

Json schema_of(const pm_mechanism& mechanism) {
  const Machine machine(mechanism, default_values(mechanics::describe(mechanism)));
  const MechanismInfo& info = machine.info();
  const NamesByKind names = names_of(info, machine.topology());
  return whole("pmreport scenario of " + info.name, shape_of_scenario(mechanism, machine.topology()), names,
               {{"const", info.name}, {"description", info.title}}, json_of_parameters(info));
}

// Of any mechanism: what the scenarios of those that were found have in common, and open where a mechanism has names of its own.
Json schema_of_any(const host::Catalog& catalog) {
  Shape common = Shape::either({});
  Json found = Json::array();
  for (const host::Entry& e : catalog.entries()) {
    found.push_back(e.name);
    try {
      const Machine machine(*e.mechanism, default_values(mechanics::describe(*e.mechanism)));
      common = merged(common, without_names(shape_of_scenario(*e.mechanism, machine.topology()), machine.topology()));
    } catch (const mechanics::MechanismError& error) {  // the others tell as much
      tell("warning: {} is passed over: {}\n", e.name, error.what());
    }
  }
  // Another plugin may bring another mechanism.
  return whole("pmreport scenario", common, {}, {{"anyOf", {{{"enum", std::move(found)}}, {{"type", "string"}}}}}, {{"type", "object"}});
}

}  // namespace

int schema(const Options& options) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  tell_refused(catalog);
  const std::string& name = options.names.front();
  if (name.empty() && catalog.entries().empty()) throw host::PluginError("no mechanism found whose scenarios a schema could describe");
  const Json out = name.empty() ? schema_of_any(catalog) : schema_of(*mechanisms_named(catalog, name).front());
  put("{}\n", out.dump(2));
  return all_well;
}

}  // namespace pmreport::program
