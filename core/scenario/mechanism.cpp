#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/mechanism_part.hpp>
#include <core/text/digits.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

using mechanics::ParameterInfo;

std::string shown(double si, const ParameterInfo& info) {
  const auto unit = parse_unit(info.display);
  return unit ? fmt::format("{}{}{}", format_number(si / unit->factor, 6), info.display.empty() ? "" : " ", info.display)
              : fmt::format("{}{}{}", format_number(si, 6), info.unit.empty() ? "" : " ", info.unit);
}

// Outside the range, so that its digits tell it from the end.
std::string shown_outside(double si, const ParameterInfo& info) {
  const auto unit = parse_unit(info.display);
  const double factor = unit ? unit->factor : 1;
  const std::string& symbol = unit ? info.display : info.unit;
  return format_outside(si / factor, info.min / factor, info.max / factor, 6) + (symbol.empty() ? "" : " " + symbol);
}

std::optional<std::vector<double>> read_parameter(const Value& value, const ParameterInfo& info, const Reader& reader) {
  if (info.kind == PM_CHOICE) {
    const auto index = reader.word(value, info.choices, fmt::format("the choices of {}", info.name));
    return index ? std::optional(std::vector{static_cast<double>(*index)}) : std::nullopt;
  }
  if (info.kind == PM_NUMBER) {
    const auto number = read_parameter_number(value, info, reader);
    return number ? std::optional(std::vector{*number}) : std::nullopt;
  }
  if (value.kind == Value::Kind::refused) return std::nullopt;
  if (value.kind != Value::Kind::array || value.items.size() < info.count_min || value.items.size() > info.count_max) {
    const std::string count =
        info.count_min == info.count_max ? fmt::format("{}", info.count_min) : fmt::format("{} to {}", info.count_min, info.count_max);
    reader.diagnostics().add(value.place,
                             fmt::format("expected a list of {} numbers for {}, seen {}", count, info.name,
                                         value.kind == Value::Kind::array ? fmt::format("{}", value.items.size()) : name_of(value)));
    return std::nullopt;
  }
  std::vector<double> out;
  for (const Value& item : value.items)
    if (const auto number = read_parameter_number(item, info, reader)) out.push_back(*number);
  return out.size() == value.items.size() ? std::optional(out) : std::nullopt;
}

// The parameter that a sentence of the mechanism is about: the first that it names and the scenario sets.
const Entry* blamed(const std::string& sentence, const Value* parameters) {
  const auto is_word = [](char c) { return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); };
  const Entry* best = nullptr;
  std::size_t first = std::string::npos;
  if (parameters == nullptr) return nullptr;
  for (const Entry& e : parameters->entries)
    for (std::size_t at = sentence.find(e.key); at < first; at = sentence.find(e.key, at + 1)) {
      const std::size_t end = at + e.key.size();
      if ((at > 0 && is_word(sentence[at - 1])) || (end < sentence.size() && is_word(sentence[end]))) continue;
      best = &e;
      first = at;
    }
  return best;
}

// Something to judge the other parts by although parameters are wrong: the mechanism with the choices that were made and all else at
// default.
std::optional<Topology> assumed_topology(const pm_mechanism& table, const MechanismPart& part) {
  mechanics::ParameterValues values = mechanics::default_values(part.info);
  for (const std::size_t i : part.set)
    if (part.info.parameters[i].kind == PM_CHOICE) values[i] = part.values[i];
  try {
    return mechanics::Machine(table, values).topology();
  } catch (const mechanics::MechanismError& e) {
    if (e.status != PM_BAD_ARGUMENT) throw;
    return std::nullopt;
  }
}

}  // namespace

std::optional<double> read_parameter_number(const Value& value, const ParameterInfo& info, const Reader& reader) {
  const auto number = reader.quantity(value, parse_unit(info.unit).value_or(Unit{}).dimension);
  if (!number) return std::nullopt;
  // The range may end at a round number of the display unit, which its SI value meets only to rounding.
  const double slack = 1e-12 * std::max(std::abs(info.min), std::abs(info.max));
  if (*number >= info.min - slack && *number <= info.max + slack) return std::clamp(*number, info.min, info.max);
  reader.diagnostics().add(value.place, fmt::format("expected {} to {} for {}, seen {}", shown(info.min, info), shown(info.max, info),
                                                    info.name, shown_outside(*number, info)));
  return std::nullopt;
}

std::optional<std::string> silenced_by(const mechanics::MechanismInfo& info, std::size_t parameter, const std::vector<std::size_t>& set) {
  const std::string& other = info.parameters[parameter].unless;
  const bool given = std::ranges::any_of(set, [&](std::size_t i) { return info.parameters[i].name == other; });
  return given ? std::optional(other) : std::nullopt;
}

bool read_parameters(const Entry& entry, const std::string& where, const mechanics::MechanismInfo& info, mechanics::ParameterValues& values,
                     std::vector<std::size_t>& set, const Reader& reader) {
  const Value* parameters = table_of(&entry, entry.key, reader);
  if (parameters == nullptr) return false;
  bool sound = true;
  TableReader given(*parameters, where, entry.place, reader);
  std::vector<std::size_t> here;
  for (std::size_t i = 0; i < info.parameters.size(); ++i) {
    const Entry* e = given.find(info.parameters[i].name);
    if (e == nullptr) continue;
    const auto value = read_parameter(e->value, info.parameters[i], reader);
    sound = sound && value.has_value();
    if (!value) continue;
    values[i] = *value;
    here.push_back(i);
  }
  given.finish();
  for (const std::size_t i : here)
    if (std::ranges::find(set, i) == set.end()) set.push_back(i);
  for (const std::size_t i : here) {
    const std::optional<std::string> other = silenced_by(info, i, set);
    if (!other) continue;
    reader.diagnostics().add(given.find(info.parameters[i].name)->place,
                             fmt::format("{} says nothing once {} is given", info.parameters[i].name, *other), "keep one of the two");
    sound = false;
  }
  return sound;
}

MechanismPart read_mechanism(const Entry* entry, const MechanismSource& source, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  MechanismPart part;
  if (entry == nullptr) {
    diagnostics.add(Place{}, "expected the table [mechanism], which is not there",
                    source.names.empty() ? "write [mechanism] and use = \"NAME\""
                                         : fmt::format("write [mechanism] and use = \"{}\"", source.names.front()));
    return part;
  }
  const Value* content = table_of(entry, "mechanism", reader);
  if (content == nullptr) return part;
  TableReader table(*content, "[mechanism]", entry->place, reader);
  const Entry* use = table.need("use", fmt::format("use = \"{}\"", source.names.empty() ? "NAME" : source.names.front()));
  const Entry* parameters_entry = table.find("parameters");
  table.finish();
  const Value* parameters = table_of(parameters_entry, "mechanism.parameters", reader);
  const auto name = use != nullptr ? reader.text(use->value) : std::nullopt;
  if (!name) return part;
  part.name = *name;
  const pm_mechanism* mechanism = source.find(*name);
  if (mechanism == nullptr) {
    diagnostics.add(use->value.place, fmt::format("no mechanism is called {}{}", in_quotes(*name), did_you_mean(*name, source.names)),
                    source.names.empty() ? "no mechanism was found at all; look at the plugin path"
                                         : fmt::format("the mechanisms are {}", listed(source.names, "and")));
    return part;
  }
  part.info = mechanics::describe(*mechanism);
  part.values = mechanics::default_values(part.info);

  bool sound = parameters_entry == nullptr || parameters != nullptr;
  if (parameters != nullptr)
    sound = read_parameters(*parameters_entry, "[mechanism.parameters] of " + part.name, part.info, part.values, part.set, reader);
  if (sound) {
    try {
      part.machine = std::make_unique<mechanics::Machine>(*mechanism, part.values);
      part.topology = part.machine->topology();
      return part;
    } catch (const mechanics::MechanismError& e) {
      if (e.status != PM_BAD_ARGUMENT) throw;
      const Entry* culprit = blamed(e.what(), parameters);
      diagnostics.add(culprit != nullptr ? culprit->place : entry->place,
                      fmt::format("{} refuses its parameters: {}", part.name, printable(e.what())));
    }
  }
  part.topology = assumed_topology(*mechanism, part);
  return part;
}

}  // namespace pmreport::scenario
