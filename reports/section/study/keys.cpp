#include <reports/section/study/keys.hpp>

#include <core/scenario/section/keys.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using scenario::Entry;
using scenario::Reading;
using scenario::Shape;
using scenario::Value;
namespace keys = scenario::keys;
using O = StudyOptions;

namespace {

const char* const questions[] = {"sweep", "variants", "optimise", "pareto"};

void read_name(const Entry& e, const Reading& r, O& options) { options.name = read_section_name(e.value, r.reader); }

void read_measure(const Entry& e, const Reading& r, O& options) {
  std::vector<std::string> seen;
  for (const Value& item : items_of(e, most_numbers, r.reader))
    if (read_studied_number(item, r, options)) add_once(seen, item.text, item, r.reader);
}

// A variant is told by its name, which is unique, and is another in something.
void read_variant(const Value& content, const Reading& r, O& options) {
  scenario::TableReader table(content, "a variant", content.place, r.reader);
  scenario::Diagnostics& diagnostics = r.reader.diagnostics();
  StudiedVariant out;
  const Entry *name = table.need("name", "name = \"longer legs\""), *other = table.find("scenario"), *parameters = table.find("parameters");
  table.finish();
  if (name != nullptr) out.name = r.reader.text(name->value).value_or("");
  constexpr std::size_t longest_name = 40;  // bytes: more leaves no room beside them in a figure
  if (name != nullptr && (out.name.empty() || out.name.size() > longest_name))
    diagnostics.add(name->value.place, fmt::format("expected a name of 1 to {} bytes, seen {}", longest_name, out.name.size()));
  if (name != nullptr && std::ranges::any_of(options.variants, [&](const StudiedVariant& v) { return v.name == out.name; }))
    diagnostics.add(name->value.place, fmt::format("a variant called {} stands before", in_quotes(out.name)));
  if (other != nullptr) {
    out.other = read_other_scenario(other->value, *r.origin, r.reader);
    if (!out.other) return;
    out.file = other->value.text;
    out.parameters = out.other->scenario.parameters;
    const auto requests = requests_elsewhere(options, *out.other, other->value, r.reader);
    if (!requests) return;
    out.requests = *requests;
  } else {
    if (!r.mechanism.machine) return;
    out.parameters = r.mechanism.values;
    out.requests = options.study.requests;
  }
  if (parameters != nullptr) {
    const mechanics::MechanismInfo& info = out.other ? out.other->machine->info() : r.mechanism.info;
    std::vector<std::size_t> set = out.other ? out.other->scenario.parameters_set : r.mechanism.set;
    const std::vector<std::size_t> before = set;
    const mechanics::ParameterValues values = out.parameters;
    if (!read_parameters(*parameters, "parameters of the variant", info, out.parameters, set, r.reader)) return;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (out.parameters[i] != values[i]) out.changed.push_back(i);
  }
  options.variants.push_back(std::move(out));
}

Shape names_of_numbers() { return Shape::either({Shape::text(), Shape::list(1, 2, Shape::text())}); }

std::vector<scenario::Key> search_keys(bool front) {
  const Shape constraint = Shape::table({keys::within("that", Shape::text(), "a number"),
                                         keys::within("below", Shape::quantity(std::nullopt), "that it must not exceed"),
                                         keys::within("above", Shape::quantity(std::nullopt), "that it must not fall below")});
  std::vector<scenario::Key> out{
      keys::within("maximise", front ? names_of_numbers() : Shape::text(), front ? "one or both" : "a number"),
      keys::within("minimise", front ? names_of_numbers() : Shape::text(), front ? "the others, two in all" : "instead"),
      keys::within("over", Shape::values_of("parameters"), "each from one end to the other"),
      keys::within("subject_to", Shape::list(1, most_constraints, constraint), "", "nothing"),
      keys::within("evaluations", Shape::whole(fewest_trials, most_variants), "variants that are tried at most",
                   front ? std::to_string(pareto_evaluations) : std::to_string(O().evaluations))};
  if (front) out.push_back(keys::within("points", Shape::whole(fewest_points, most_points), "of the front", std::to_string(O().points)));
  return out;
}

}  // namespace

void read_variants(const Entry& e, const Reading& r, O& options) {
  for (const Value& item : items_of(e, most_machines, r.reader)) {
    if (item.kind == Value::Kind::table)
      read_variant(item, r, options);
    else if (item.kind != Value::Kind::refused)
      r.reader.diagnostics().add(item.place, fmt::format("expected a variant, seen {}", name_of(item)),
                                 "write { name = \"inner\", parameters = { ... } } or { name = \"other\", scenario = \"other.toml\" }");
  }
}

std::vector<scenario::Key> study_keys() {
  const Shape variant =
      Shape::table({keys::within("name", Shape::text(), ""),
                    keys::within("scenario", Shape::text(), "a file beside this one, with a section `workspace` of its own", "this one"),
                    keys::within("parameters", Shape::values_of("parameters"), "that it has instead")});
  const auto asked = [](O::Asked what, auto read) {
    return [what, read](const Entry& e, const Reading& r, O& options) {
      options.asked = what;
      if (options.numbers.empty() && (what == O::Asked::sweep || what == O::Asked::variants)) {
        Value volume;
        volume.kind = Value::Kind::text, volume.text = "workspace.volume", volume.place = e.place;
        if (!read_studied_number(volume, r, options)) return;
      }
      read(e, r, options);
    };
  };
  return {
      keys::of<O>("name", Shape::text(), "of this section among several: its files are then called `study-NAME`", "none", read_name),
      keys::late(keys::of<O>("measure", Shape::list(1, most_numbers, Shape::text()),
                             "numbers of the scenario's sections `workspace`, `workspace.volume`, `workspace.x_low`, `workspace.x_high`, "
                             "and of home, `home.condition`, `home.smallest_singular_value`",
                             "`[\"workspace.volume\"]`", read_measure)),
      keys::late(keys::of<O>("sweep", Shape::values_of("parameters"),
                             "one or two with from, to and how many, `{base_radius = [\"250 mm\", \"400 mm\", 7]}`", "",
                             asked(O::Asked::sweep, read_sweep))),
      keys::late(keys::of<O>("variants", Shape::list(1, most_machines, variant), "machines laid beside this one", "",
                             asked(O::Asked::variants, read_variants))),
      keys::late(
          keys::of<O>("optimise", Shape::table(search_keys(false)),
                      "the best variant, `{maximise = \"workspace.volume\", over = {base_radius = [\"200 mm\", \"500 mm\"]}, subject_to = "
                      "[{that = \"home.condition\", below = \"40\"}]}`",
                      "", asked(O::Asked::optimise, read_optimise))),
      keys::late(keys::of<O>("pareto", Shape::table(search_keys(true)), "the best variants between two goals", "",
                             asked(O::Asked::pareto, read_pareto)))};
}

void complete_study(scenario::TableReader& table, const Reading& r, scenario::Options&) {
  std::vector<const Entry*> asked;
  for (const char* question : questions)
    if (const Entry* e = table.find(question)) asked.push_back(e);
  if (asked.empty())
    r.reader.diagnostics().add(table.place(), "a section \"study\" has nothing to do: expected sweep, variants, optimise or pareto",
                               "write sweep = { PARAMETER = [\"from\", \"to\", 7] }");
  for (std::size_t i = 1; i < asked.size(); ++i)
    r.reader.diagnostics().add(asked[i]->place,
                               fmt::format("a study asks one question, and {} stands before {}", asked[0]->key, asked[i]->key),
                               "give each a section of its own");
}

}  // namespace pmreport::section
