// [limits]: what actuators and joints may be asked for.
#include <fmt/format.h>

#include <algorithm>
#include <core/mechanics/machine/joint_words.hpp>
#include <core/scenario/sizing_part.hpp>
#include <core/text/digits.hpp>
#include <core/text/text.hpp>

namespace pmreport::scenario {
namespace {

constexpr double least_limit = 1e-6, largest_limit = 1e12;  // SI
constexpr const char* how_to_have_none = "leave out what has no limit";

// Something that a limit is on.
struct Subject {
  std::string name, unit;  // SI; empty: there is nothing to limit
  std::string kind;        // "linear" or "rotary"; "spherical joint"
  bool limited() const { return !unit.empty(); }
};

constexpr const char* without_moment = "transmits no moment about its centre: there is nothing to limit";

std::string example(const Subject& s) { return fmt::format("{} = \"{}\"", s.name, example_of(parse_unit(s.unit)->dimension)); }

double read_one(const Entry& e, const Subject& s, const Reader& reader) {
  return read_within(e, least_limit, largest_limit, s.unit, how_to_have_none, reader).value_or(mechanics::MotionLimits::none);
}

void read_for_all(const Entry& e, const std::vector<Subject>& subjects, const Reader& reader, std::vector<double>& out) {
  const auto first = std::find_if(subjects.begin(), subjects.end(), [](const Subject& s) { return s.limited(); });
  if (first == subjects.end()) return reader.diagnostics().add(e.place, fmt::format("no joint of this mechanism {}", without_moment));
  const auto other = std::find_if(first, subjects.end(), [&](const Subject& s) { return s.limited() && s.unit != first->unit; });
  if (other != subjects.end())
    return reader.diagnostics().add(e.value.place,
                                    fmt::format("expected a table by name, seen one value for all: {} is {}, and {} is {}", first->name,
                                                first->kind, other->name, other->kind),
                                    fmt::format("write {} = {{ {}, {} }}", e.key, example(*first), example(*other)));
  const double limit = read_one(e, *first, reader);
  for (std::size_t i = 0; i < subjects.size(); ++i)
    if (subjects[i].limited()) out[i] = limit;
}

void read_by_name(const Entry& e, const std::vector<Subject>& subjects, const Reader& reader, std::vector<double>& out) {
  if (e.value.entries.empty())
    return reader.diagnostics().add(e.place, fmt::format("expected limits by name in limits.{}, seen an empty table", e.key),
                                    how_to_have_none);
  TableReader table(e.value, "limits." + e.key, e.place, reader);
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const Entry* own = table.find(subjects[i].name);
    if (own == nullptr) continue;
    if (subjects[i].limited())
      out[i] = read_one(*own, subjects[i], reader);
    else
      reader.diagnostics().add(own->place, fmt::format("{} is a {} and {}", subjects[i].name, subjects[i].kind, without_moment));
  }
  table.finish();
}

// One value for all subjects, or a table by name.
std::vector<double> read_limit(TableReader& table, std::string_view key, const std::vector<Subject>& subjects) {
  std::vector<double> out(subjects.size(), mechanics::MotionLimits::none);
  if (const Entry* e = table.find(key))
    (e->value.kind == Value::Kind::table ? read_by_name : read_for_all)(*e, subjects, table.read(), out);
  return out;
}

std::vector<Subject> actuators_of(const Topology& t, const char* unit_if_linear, const char* unit_if_rotary) {
  std::vector<Subject> out;
  for (const Actuator& a : t.actuators) {
    const bool linear = a.sense() == Sense::linear;
    out.push_back({a.name, linear ? unit_if_linear : unit_if_rotary, linear ? "linear" : "rotary"});
  }
  return out;
}

std::vector<Subject> joints_of(const Topology& t, bool moments) {
  std::vector<Subject> out;
  for (const Joint& j : t.joints)
    out.push_back({j.name,
                   !moments                         ? "N"
                   : j.kind != JointKind::spherical ? "N*m"
                                                    : "",
                   fmt::format("{} joint", mechanics::word_of(j.kind))});
  return out;
}

}  // namespace

std::optional<double> read_within(const Entry& entry, double least, double most, const std::string& unit, const std::string& hint,
                                  const Reader& reader) {
  const Unit in = parse_unit(unit).value();
  const auto value = reader.quantity(entry.value, in.dimension);
  if (!value) return std::nullopt;
  // The range ends at round numbers of the unit, which their SI values meet only to rounding.
  constexpr double slack = 1e-12;
  const double low = least * in.factor, high = most * in.factor;
  if (*value >= low * (1 - slack) && *value <= high * (1 + slack)) return std::clamp(*value, low, high);
  const auto in_unit = [&](const std::string& number) { return number + (unit.empty() ? "" : " " + unit); };
  reader.diagnostics().add(
      entry.value.place,
      fmt::format("expected {} to {} for {}, seen {}", in_unit(format_number(least, 6)), in_unit(format_number(most, 6)), entry.key,
                  in_unit(format_outside(*value / in.factor, least, most, 6))),
      hint);
  return std::nullopt;
}

mechanics::MotionLimits read_limits(const Entry* entry, const MechanismPart& mechanism, const Reader& reader) {
  mechanics::MotionLimits limits;
  if (!mechanism.topology) return limits;
  const Topology& t = *mechanism.topology;
  const Value nothing;
  const Value* content = table_of(entry, "limits", reader);
  TableReader table(content != nullptr ? *content : nothing, "[limits]", entry != nullptr ? entry->place : Place{}, reader);
  limits.force = read_limit(table, "actuator_force", actuators_of(t, "N", "N*m"));
  limits.speed = read_limit(table, "actuator_speed", actuators_of(t, "m/s", "rad/s"));
  limits.power = read_limit(table, "actuator_power", actuators_of(t, "W", "W"));
  limits.joint_force = read_limit(table, "joint_force", joints_of(t, false));
  limits.joint_moment = read_limit(table, "joint_moment", joints_of(t, true));
  table.finish();
  if (content != nullptr && content->entries.empty())
    reader.diagnostics().add(entry->place, "expected at least one limit in [limits], seen an empty table",
                             "add at least one of actuator_force, actuator_speed, actuator_power, joint_force and joint_moment");
  return limits;
}

}  // namespace pmreport::scenario
