// What a prescribed motion says: how each coordinate, or each actuator, moves.
#pragma once

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
  Place place;  // of what says so
  std::function<Jet<double>(double)> at;
  std::string description;
};
struct Laws {
  bool by_actuators = false;
  std::vector<double> times;  // of the points, for laws through points
  std::vector<Law> laws;      // one a coordinate, or one an actuator
};

// The laws of [motion], or nothing when something is wrong: from expressions; from waypoints; from a file.
std::optional<Laws> read_expressions(const Value& motion, const Movables& movables, const std::vector<double>& times, const Reader& reader);
std::optional<Laws> read_waypoints(const Entry& waypoints, bool quintic, const Movables& movables, const Reader& reader);
std::optional<Laws> read_motion_file(const Entry& file, bool quintic, const Movables& movables, const std::filesystem::path& scenario,
                                     const Reader& reader);

}  // namespace pmreport::scenario
