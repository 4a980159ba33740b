#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/numbers.hpp>
#include <core/scenario/motion/laws.hpp>
#include <core/scenario/motion/spline.hpp>
#include <core/scenario/motion/unwrap.hpp>
#include <core/scenario/read/beside.hpp>
#include <core/scenario/read/csv.hpp>
#include <core/text/text.hpp>
#include <memory>
#include <numbers>

namespace pmreport::scenario {
namespace {

// A spline bends by its steps: where one is a billionth of another, the bends of the short one leave no digit of the values of the long
// one.
constexpr double most_uneven = 1e9;

struct UnevenStep {
  std::size_t end;  // of the shortest step: the number of its later time
  std::string told;
};
std::optional<UnevenStep> uneven_step(const std::vector<double>& times) {
  double shortest = infinity, longest = 0;
  std::size_t end = 0;
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double step = times[i] - times[i - 1];
    longest = std::max(longest, step);
    if (step < shortest) shortest = step, end = i;
  }
  if (!(longest > most_uneven * shortest)) return std::nullopt;
  return UnevenStep{end, fmt::format("expected no step of time a billion times as long as another, seen {} s beside {} s",
                                     format_number(shortest, 3), format_number(longest, 3))};
}

constexpr double visible = 1e-3;  // of what a curve moves: how far it must go beyond its points to be worth a word

// The ends of a cubic spline, in words.
std::string ends_of(Ends ends, std::size_t points) {
  if (ends == Ends::at_rest) return "at rest at both ends";
  if (points == 2) return "a straight line";
  if (points == 3) return "one parabola";
  return "its outer two pieces one cubic at either end";
}

// The law through points. `of`: what they are, "3 waypoints".
Law through(const Moved& m, Place place, const std::vector<double>& times, std::vector<double> values, bool quintic, Ends ends,
            const std::string& of) {
  Law out{m.name, m.unit, place, {}, {}, times, {}, {}, {}};
  for (std::size_t i = 1; i + 1 < times.size(); ++i) out.switches.push_back({times[i], times[i]});
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double moves = *high - *low;
  if (quintic) {
    out.description = fmt::format("{}: quintic profile through {}, at rest in each", m.name, of);
    const auto curve = std::make_shared<const QuinticSteps>(times, std::move(values));
    out.at = [curve](double t) { return curve->at(t); };
    out.over = [curve](program::Bounds time) { return curve->over(time); };
  } else {
    const auto curve = std::make_shared<const CubicSpline>(times, std::move(values), ends);
    out.description = fmt::format("{}: cubic spline through {}, {}", m.name, of, ends_of(ends, times.size()));
    if (const auto [beyond, time] = curve->overshoot(); beyond > visible * moves) {
      const DisplayUnit unit = display_unit(m.unit, beyond);
      out.description += fmt::format(", up to {}{}{} beyond its points (at {} s)", format_number(beyond * unit.per_si, 3),
                                     unit.label == "°" ? "" : " ", unit.label, format_number(time, 4));
    }
    out.at = [curve](double t) { return curve->at(t); };
    out.over = [curve](program::Bounds time) { return curve->over(time); };
  }
  if (moves == 0) out.description = fmt::format("{}: constant", m.name);
  return out;
}

// Angles that come back by a turn are unwrapped, or taken as they stand, as the key says; where it says nothing, they are refused:
// `refuse` knows where the point stands.
bool settle_turns(const Moved& m, const std::vector<double>& times, std::vector<double>& values, std::optional<bool> unwrapped,
                  const std::function<void(std::size_t point, const std::string& message, const std::string& hint)>& refuse) {
  if (sense_of(m.unit) != Sense::rotary || unwrapped == std::optional(false)) return true;
  if (unwrapped) {
    unwrap(values);
    return true;
  }
  const auto at = wrapped_at(times, values);
  if (!at) return true;
  const double per_degree = 180 / std::numbers::pi, step = (values[*at] - values[*at - 1]) * per_degree;
  refuse(*at,
         fmt::format("{} jumps by {} deg from the point before, and a turn less, {} deg, would go on as before", m.name,
                     format_number(step, 6), format_number(step - std::copysign(360, step), 6)),
         "unwrap = true in [motion] takes the shortest way from point to point; unwrap = false takes the numbers as they stand");
  return false;
}

// Nothing: the key says nothing, or is wrong, told.
std::optional<bool> read_unwrap(const Entry* entry, const Reader& reader) {
  return entry != nullptr ? reader.boolean(entry->value) : std::nullopt;
}

}  // namespace

std::optional<Laws> read_waypoints(const Entry& waypoints, const Through& how, const Movables& movables, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  const auto tables = tables_of(&waypoints, "motion.waypoint", reader);
  if (tables.empty()) return std::nullopt;
  std::vector<Named> names;
  for (const Value* waypoint : tables)
    for (const Entry& e : waypoint->entries) names.push_back({e.key, e.place});
  const auto kind = prescribed(names, movables, false, [&](Place place, const std::string& message, const std::string& hint) {
    diagnostics.add(place, message, hint);
  });
  if (!kind) return std::nullopt;
  const std::vector<Moved>& moved = *kind->moved;
  const std::size_t dof = moved.size();
  Laws out{kind->by_actuators, {}, {}};
  std::vector<std::vector<double>> values(dof);
  bool sound = true;
  for (const Value* waypoint : tables) {
    TableReader table(*waypoint, "[[motion.waypoint]]", waypoint->place, reader);
    const Entry* time_entry = table.need("time", "time = \"2 s\"");
    const auto time = time_entry != nullptr ? reader.quantity(time_entry->value, {0, 0, 1, 0}) : std::nullopt;
    sound = sound && time.has_value();
    if (time && out.times.empty() && *time != 0) {
      diagnostics.add(time_entry->value.place, fmt::format("expected the first waypoint at 0 s, seen {} s", format_number(*time, 6)));
      sound = false;
    } else if (time && !out.times.empty() && !(*time > out.times.back())) {
      diagnostics.add(time_entry->value.place, fmt::format("expected a time after the waypoint before, {} s, seen {} s",
                                                           format_number(out.times.back(), 6), format_number(*time, 6)));
      sound = false;
    }
    if (time) out.times.push_back(*time);
    for (std::size_t j = 0; j < dof; ++j) {  // one left out keeps its last value, at first that of home
      const Entry* e = table.find(moved[j].name);
      const double before = values[j].empty() ? moved[j].home : values[j].back();
      const auto value = e != nullptr ? reader.quantity(e->value, parse_unit(moved[j].unit)->dimension) : std::optional(before);
      sound = sound && value.has_value();
      values[j].push_back(value.value_or(before));
    }
    table.finish();
  }
  if (tables.size() < 2) {
    diagnostics.add(waypoints.place, "expected at least two waypoints, seen one");
    return std::nullopt;
  }
  if (const auto uneven = sound && !how.quintic ? uneven_step(out.times) : std::nullopt) {
    diagnostics.add(tables[uneven->end]->place, uneven->told);
    sound = false;
  }
  if (!sound) return std::nullopt;
  const auto unwrapped = read_unwrap(how.unwrap, reader);
  for (std::size_t j = 0; j < dof; ++j) {
    const auto refuse = [&](std::size_t point, const std::string& message, const std::string& hint) {
      diagnostics.add(tables[point]->place, message, hint);
    };
    if (settle_turns(moved[j], out.times, values[j], unwrapped, refuse))
      out.laws.push_back(through(moved[j], waypoints.place, out.times, std::move(values[j]), how.quintic, Ends::at_rest,
                                 fmt::format("{} waypoints", tables.size())));
  }
  if (out.laws.size() < dof) return std::nullopt;
  return out;
}

std::optional<Laws> read_motion_file(const Entry& entry, const Through& how, const Movables& movables,
                                     const std::filesystem::path& scenario, const Reader& reader) {
  Diagnostics& diagnostics = reader.diagnostics();
  const auto given = reader.text(entry.value);
  const auto path = given ? file_beside(*given, entry.value.place, scenario, diagnostics) : std::nullopt;
  if (!path) return std::nullopt;
  const std::string shown = shown_beside(*given, scenario);
  auto table = read_number_table(*path, shown, max_samples, diagnostics);
  if (!table) return std::nullopt;

  bool sound = true;
  const auto refuse = [&](Place place, const std::string& message, const std::string& hint = {}) {
    diagnostics.add(Diagnostic{shown, place.line, place.column, message, {}, hint});
    sound = false;
  };
  std::vector<Named> names;
  std::vector<std::string> all{"t"};
  for (const NumberColumn& column : table->columns) names.push_back({column.name, column.place});
  for (const std::vector<Moved>* list : {&movables.coordinates, &movables.actuators})
    for (const Moved& m : *list) all.push_back(m.name);
  const auto kind = prescribed(names, movables, false, refuse);
  if (!kind) return std::nullopt;
  const std::vector<Moved>& moved = *kind->moved;
  NumberColumn* time = nullptr;
  std::vector<NumberColumn*> columns(moved.size(), nullptr);
  for (NumberColumn& column : table->columns) {
    const bool is_time = column.name == "t";
    const auto found = std::find_if(moved.begin(), moved.end(), [&](const Moved& m) { return m.name == column.name; });
    if (!is_time && found == moved.end()) {
      refuse(column.place, fmt::format("unknown column {}{}", in_quotes(column.name), did_you_mean(column.name, all)),
             fmt::format("the columns are {}", listed(all, "and")));
      continue;
    }
    NumberColumn*& slot = is_time ? time : columns[static_cast<std::size_t>(found - moved.begin())];
    const Dimension expected = is_time ? Dimension{0, 0, 1, 0} : parse_unit(found->unit)->dimension;
    if (slot != nullptr) refuse(column.place, fmt::format("column {} stands here twice", column.name));
    if (column.unit.dimension != expected)
      refuse(column.place, fmt::format("expected {} in column {}, seen the unit {} of {}", name_of(expected), column.name,
                                       in_quotes(column.unit.symbol), name_of(column.unit.dimension)));
    slot = &column;
  }
  if (time == nullptr) {
    refuse({}, "expected a column of times, \"t [s]\"");
    return std::nullopt;
  }
  for (std::size_t i = 1; i < time->values.size() && sound; ++i)
    if (!(time->values[i] > time->values[i - 1]))
      refuse({table->lines[i], 1}, fmt::format("expected a time after the row before, {} s, seen {} s",
                                               format_number(time->values[i - 1], 9), format_number(time->values[i], 9)));
  if (const auto uneven = sound && !how.quintic ? uneven_step(time->values) : std::nullopt)
    refuse({table->lines[uneven->end], 1}, uneven->told, "write the times in one unit, and leave out what stands beside another row");
  if (!sound) return std::nullopt;
  Laws out{kind->by_actuators, time->values, {}};
  const auto unwrapped = read_unwrap(how.unwrap, reader);
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const Moved& c = moved[j];
    if (columns[j] == nullptr) {
      out.laws.push_back({c.name,
                          c.unit,
                          entry.value.place,
                          [home = c.home](double) { return Jet<double>(home); },
                          fmt::format("{}: home", c.name),
                          {},
                          {},
                          {},
                          at_rest(c.home)});
      continue;
    }
    const auto refuse_row = [&](std::size_t row, const std::string& message, const std::string& hint) {
      refuse({table->lines[row], 1}, message, hint);
    };
    if (settle_turns(c, out.times, columns[j]->values, unwrapped, refuse_row))
      out.laws.push_back(through(c, entry.value.place, out.times, std::move(columns[j]->values), how.quintic, Ends::not_a_knot,
                                 fmt::format("{} rows of {}", out.times.size(), printable(*given))));
  }
  if (!sound) return std::nullopt;
  return out;
}

}  // namespace pmreport::scenario
