// What a prescribed motion says: how each coordinate, or each actuator, moves.
#pragma once

#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/expression/behaviour.hpp>
#include <core/scenario/mechanism_part.hpp>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

// A name in a motion, and where it stands.
struct Named {
  std::string name;
  Place place;
};
using Refuse = std::function<void(Place, const std::string& message, const std::string& hint)>;
// What the names prescribe: coordinates, unless they are actuators. Nothing, told, when they are some of both; names of neither count for
// nothing. `suffix`: names may end in "_rate".
struct Prescribed {
  bool by_actuators = false;
  const std::vector<Moved>* moved = nullptr;
};
std::optional<Prescribed> prescribed(const std::vector<Named>& names, const Movables& movables, bool suffix, const Refuse& refuse);

// The law by which one coordinate or actuator moves, whatever says so.
struct Law {
  std::string name;
  std::string unit;  // SI
  Place place;       // of what says so
  std::function<Jet<double>(double)> at;
  std::string description;
  // Over the whole motion; of a law at rest nothing.
  std::vector<double> steps = {};     // rising: between two neighbours a handful of points show all that it does
  std::vector<Switch> switches = {};  // inside, rising: where a derivative may jump
  std::vector<mechanics::Break> breaks = {};
  // The same over a span of time, within the motion: bounds at every instant, both sides of a switch in, rounding included. Not bounded
  // where nothing is known.
  std::function<Jet<program::Bounds>(program::Bounds)> over = {};
};
// `over` of a law at rest.
inline auto at_rest(double value) {
  using program::Bounds;
  return [value](Bounds) { return Jet<Bounds>(Bounds::exactly(value), Bounds::exactly(0), Bounds::exactly(0)); };
}
// Which of its switches are breaks: the law is taken on both sides, and what differs by more than its rounding jumps; by infinity, where a
// derivative grows beyond all bounds.
std::vector<mechanics::Break> breaks_of(const Law& law);

struct Laws {
  bool by_actuators = false;
  std::vector<double> times;  // of the points, for laws through points
  std::vector<Law> laws;      // one a coordinate, or one an actuator
};

// False, told where the law stands, when one of its breaks has no bound.
bool bounded(const Law& law, const std::vector<mechanics::Break>& breaks, Diagnostics& diagnostics);

// How laws lead through points.
struct Through {
  bool quintic = false;           // at rest at every point; else a cubic spline
  const Entry* unwrap = nullptr;  // the key, where it stands
};
// The laws of [motion], or nothing when something is wrong: from expressions, over that many
// seconds (nothing: it is not known, and their mistakes alone are told); from waypoints; from a file.
std::optional<Laws> read_expressions(const Value& motion, const Movables& movables, std::optional<double> duration, const Reader& reader);
std::optional<Laws> read_waypoints(const Entry& waypoints, const Through& how, const Movables& movables, const Reader& reader);
std::optional<Laws> read_motion_file(const Entry& file, const Through& how, const Movables& movables, const std::filesystem::path& scenario,
                                     const Reader& reader);

}  // namespace pmreport::scenario
