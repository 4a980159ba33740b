// The parts of a scenario, each read and validated by itself: a mistake in one does not hide those in the others.
#pragma once

#include <core/scenario/reader.hpp>
#include <core/scenario/scenario.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct MechanismPart {
  std::string name;
  mechanics::MechanismInfo info;
  mechanics::ParameterValues values;
  std::vector<std::size_t> set;
  std::unique_ptr<mechanics::Machine> machine;  // nullptr when something is wrong
  std::optional<Topology> topology;             // to judge the other parts by; nothing when the mechanism is unknown
};
MechanismPart read_mechanism(const Entry* entry, const MechanismSource& source, const Reader& reader);

struct Interval {
  double begin = 0, end = 0;  // [s]
};

struct MotionPart {
  Motion motion;
  std::optional<Interval> interval;  // nothing when it is not known
};
MotionPart read_motion(const Entry* entry, const MechanismPart& mechanism, const std::filesystem::path& scenario, const Reader& reader);

// How one coordinate moves, whatever says so.
struct Curve {
  std::string name;
  Place place;  // of what says so
  std::function<Jet<double>(double)> at;
  std::string description;
};

// The curves of [motion] that come from waypoints, or from a file: one a coordinate, and the times of the points. Nothing when something is
// wrong.
struct Knots {
  std::vector<double> times;
  std::vector<Curve> curves;
};
std::optional<Knots> read_waypoints(const Entry& waypoints, bool quintic, const Topology& topology, const Reader& reader);
std::optional<Knots> read_motion_file(const Entry& file, bool quintic, const Topology& topology, const std::filesystem::path& scenario,
                                      const Reader& reader);

// A coordinate that is named but cannot be given: unknown, or dependent.
void refuse_coordinate(Place place, const std::string& name, const MechanismPart& mechanism, std::vector<std::string> known,
                       const std::string& where, Diagnostics& diagnostics);

Load read_load(const Entry* entry, const std::vector<double>& time, const Reader& reader);

// A section whose kind cannot be read keeps an empty one.
std::vector<SectionRequest> read_sections(const Entry* entry, const std::optional<Interval>& interval, const Reader& reader);

std::vector<Check> read_checks(const Entry* entry, const std::vector<SectionRequest>& sections, const std::optional<Topology>& topology,
                               const std::optional<Interval>& interval, const Reader& reader);

// The tables of an array of tables, [[name]]; a single table or anything else is reported.
std::vector<const Value*> tables_of(const Entry* entry, const std::string& name, const Reader& reader);

// The value of `entry` when it is a table, else reported and nullptr.
const Value* table_of(const Entry* entry, const std::string& name, const Reader& reader);

// Reports the first time at which a curve has no finite value, rate or acceleration. True when it is finite.
bool finite(const Jet<double>& x, double t, Place place, const std::string& what, Diagnostics& diagnostics);

}  // namespace pmreport::scenario
