#include <fmt/format.h>

#include <algorithm>
#include <core/scenario/expression/enclosure.hpp>
#include <core/scenario/expression/integral.hpp>
#include <core/scenario/expression/integral_enclosure.hpp>
#include <core/scenario/motion/laws.hpp>
#include <core/text/text.hpp>
#include <memory>

namespace pmreport::scenario {
namespace {

using program::Bounds;

constexpr std::string_view rate_suffix = "_rate";

Law at_home(const Moved& m) {
  const double home = m.home;
  const DisplayUnit unit = display_unit(m.unit, home);
  return {m.name,
          m.unit,
          {},
          [home](double) { return Jet<double>(home); },
          fmt::format("{} = {}{}{} (home)", m.name, format_number(home * unit.per_si, 6), unit.label == "°" ? "" : " ", unit.label),
          {},
          {},
          {},
          at_rest(home)};
}

// How the expression of one of them behaves; nothing, told, where it wavers beyond all looking.
std::optional<Behaviour> behaviour_of(const Written& written, const std::string& name, double duration, Diagnostics& diagnostics) {
  Behaviour out = behaviour(written.expression, 0, duration);
  if (out.complete) return out;
  diagnostics.add(written.place,
                  fmt::format("{} wavers or switches more often over {} s than can be looked at", name, format_number(duration, 6)),
                  "look at a shorter motion, or at a slower one");
  return std::nullopt;
}

// Nothing, told, where it has no finite value or derivative.
std::optional<Law> from_value(const Moved& m, Written written, Behaviour behaviour, Diagnostics& diagnostics) {
  const auto value = std::make_shared<const Expression>(std::move(written.expression));
  Law out{m.name,
          m.unit,
          written.place,
          [value](double t) { return value->at(t); },
          fmt::format("{} = {}", m.name, printable(written.text)),
          std::move(behaviour.steps),
          std::move(behaviour.switches),
          {},
          [value](Bounds time) { return over(*value, time); }};
  out.breaks = breaks_of(out);
  if (!bounded(out, out.breaks, diagnostics)) return std::nullopt;
  return out;
}

std::vector<double> rising(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// From a rate: the value is its integral from home, the acceleration its exact derivative. Between its steps the rate is a matter of a few
// points, and at its switches the integral begins anew. Nothing, told, when it is not good all the same.
std::optional<Law> from_rate(const Moved& m, Written written, Behaviour behaviour, Diagnostics& diagnostics) {
  constexpr double good = 1e-9;  // of the way there and back
  const auto rate = std::make_shared<const Expression>(std::move(written.expression));
  const Law itself{m.name, m.unit, written.place, [rate](double t) { return rate->at(t); }, "", behaviour.steps, behaviour.switches,
                   {},     {}};
  std::vector<mechanics::Break> breaks = breaks_of(itself);
  std::erase_if(breaks, [](const mechanics::Break& b) { return b.of == mechanics::Break::Of::acceleration; });
  for (mechanics::Break& b : breaks)  // of what is integrated they are one derivative higher
    b.of = b.of == mechanics::Break::Of::value ? mechanics::Break::Of::rate : mechanics::Break::Of::acceleration;
  if (!bounded(itself, breaks, diagnostics)) return std::nullopt;
  std::vector<double> knots = behaviour.steps;
  for (const Switch& s : behaviour.switches) knots.push_back(s.time());
  const auto value = std::make_shared<const Integral>([rate](double t) { return rate->at(t); }, m.home, rising(std::move(knots)));
  if (value->error() > good * value->magnitude()) {
    const DisplayUnit unit = display_unit(m.unit, value->error());
    diagnostics.add(written.place,
                    fmt::format("the integral of {}{} is good to {} {} alone: it jumps or grows where nobody can tell", m.name, rate_suffix,
                                format_number(value->error() * unit.per_si, 3), unit.label),
                    fmt::format("give {} itself", m.name));
    return std::nullopt;
  }
  std::vector<double> sides = behaviour.steps;
  for (const Switch& s : behaviour.switches) sides.insert(sides.end(), {s.before, s.after});
  const auto proved = std::make_shared<const IntegralEnclosure>(*rate, m.home, rising(std::move(sides)), value->magnitude());
  return Law{m.name,
             m.unit,
             written.place,
             [rate, value](double t) {
               const Jet<double> v = rate->at(t);
               return Jet<double>(value->at(t), v.value, v.rate);
             },
             fmt::format("{}{} = {}", m.name, rate_suffix, printable(written.text)),
             std::move(behaviour.steps),
             std::move(behaviour.switches),
             std::move(breaks),
             [proved](Bounds time) { return proved->over(time); }};
}

const Entry* entry_of(const Value& table, const std::string& key) {
  const auto found = std::find_if(table.entries.begin(), table.entries.end(), [&](const Entry& e) { return e.key == key; });
  return found != table.entries.end() ? &*found : nullptr;
}

const Moved* named(const std::vector<Moved>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Moved& m) { return m.name == name; });
  return found != list.end() ? &*found : nullptr;
}

}  // namespace

std::optional<Prescribed> prescribed(const std::vector<Named>& names, const Movables& movables, bool suffix, const Refuse& refuse) {
  const Named* first[2] = {nullptr, nullptr};  // a coordinate, an actuator
  for (const Named& n : names) {
    const std::string base = suffix ? without_rate(n.name) : n.name;
    const bool coordinate = named(movables.coordinates, base) != nullptr,
               actuator = !coordinate && named(movables.actuators, base) != nullptr;
    if (!coordinate && !actuator) continue;
    if (first[actuator] == nullptr) first[actuator] = &n;
    if (first[0] == nullptr || first[1] == nullptr) continue;
    refuse(n.place,
           fmt::format("{} is {}, and {} before it {}: a motion prescribes coordinates or actuators, and the others follow", n.name,
                       actuator ? "an actuator" : "a coordinate", first[!actuator]->name, actuator ? "a coordinate" : "an actuator"),
           fmt::format("keep to the coordinates {}, or to the actuators {}", names_of(movables.coordinates), names_of(movables.actuators)));
    return std::nullopt;
  }
  const bool by_actuators = first[1] != nullptr;
  return Prescribed{by_actuators, by_actuators ? &movables.actuators : &movables.coordinates};
}

std::optional<Laws> read_expressions(const Value& motion, const Movables& movables, std::optional<double> duration, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  std::vector<Named> names;
  for (const Entry& e : motion.entries) names.push_back({e.key, e.place});
  const auto kind = prescribed(names, movables, true, [&](Place place, const std::string& message, const std::string& hint) {
    diagnostics.add(place, message, hint);
  });
  Laws out;
  bool sound = kind.has_value();
  for (const std::vector<Moved>* list : {&movables.coordinates, &movables.actuators}) {
    const bool meant = kind && list == kind->moved;
    for (const Moved& m : *list) {
      const Entry *value = entry_of(motion, m.name), *rate = entry_of(motion, m.name + std::string(rate_suffix));
      if (value != nullptr && rate != nullptr) {
        diagnostics.add(std::max(value, rate)->place, fmt::format("{} is given twice: by its value and by its rate", m.name),
                        "keep one of the two");
        sound = false;
      }
      const Dimension dimension = parse_unit(m.unit)->dimension;
      auto by_value = value != nullptr ? reader.expression(value->value, dimension, Time::allowed) : std::nullopt;
      auto by_rate = rate != nullptr ? reader.expression(rate->value, dimension / Dimension{0, 0, 1, 0}, Time::allowed) : std::nullopt;
      sound = sound && (value == nullptr || by_value) && (rate == nullptr || by_rate);
      if (!meant || !duration) continue;
      if (!by_value && !by_rate) {
        out.laws.push_back(at_home(m));
        continue;
      }
      Written written = std::move(by_value ? *by_value : *by_rate);
      auto behaviour = behaviour_of(written, by_value ? m.name : m.name + std::string(rate_suffix), *duration, diagnostics);
      std::optional<Law> law;
      if (behaviour)
        law = by_value ? from_value(m, std::move(written), std::move(*behaviour), diagnostics)
                       : from_rate(m, std::move(written), std::move(*behaviour), diagnostics);
      sound = sound && law;
      if (law) out.laws.push_back(std::move(*law));
    }
  }
  if (!sound || !duration) return std::nullopt;
  out.by_actuators = kind->by_actuators;
  return out;
}

}  // namespace pmreport::scenario
