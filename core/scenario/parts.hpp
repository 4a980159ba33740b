// The parts of a scenario, each read and validated by itself: a mistake in one does not hide those in the others.
#pragma once

#include <core/scenario/read/reader.hpp>
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
// `load`: a motion that follows from forces feels it.
MotionPart read_motion(const Entry* entry, const MechanismPart& mechanism, const Load& load, const std::filesystem::path& scenario,
                       const Reader& reader);

// What a motion may prescribe: the independent coordinates, or the actuators, never some of both.
struct Moved {
  std::string name, unit;  // SI
  double home = 0;
};
struct Movables {
  explicit Movables(const MechanismPart& mechanism);  // whose topology is known
  std::vector<Moved> coordinates, actuators;
};

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

// How one coordinate or actuator moves, whatever says so.
struct Curve {
  std::string name;
  Place place;  // of what says so
  std::function<Jet<double>(double)> at;
  std::string description;
};
struct Curves {
  bool by_actuators = false;
  std::vector<double> times;  // of the points, for curves through points
  std::vector<Curve> curves;  // one a coordinate, or one an actuator
};

// The curves of [motion], or nothing when something is wrong: from expressions; from waypoints; from a file.
std::optional<Curves> read_expressions(const Value& motion, const Movables& movables, const std::vector<double>& times,
                                       const Reader& reader);
std::optional<Curves> read_waypoints(const Entry& waypoints, bool quintic, const Movables& movables, const Reader& reader);
std::optional<Curves> read_motion_file(const Entry& file, bool quintic, const Movables& movables, const std::filesystem::path& scenario,
                                       const Reader& reader);

// "q1" of "q1_rate", else the name itself.
std::string without_rate(const std::string& name);

// The motion of the coordinates that follow the motion `drive` of the actuators; `place` is where that stands. Nothing, told, when it has
// no pose to start from, or, cut off at a singular surface, too few samples.
std::optional<Motion> followed(Motion drive, const mechanics::Machine& machine, bool until_singularity, Place place,
                               Diagnostics& diagnostics);
// What [motion] says with from = "forces": where the motion begins, what the actuators exert, and what may end it.
struct Forces {
  Place place;  // of the motion's beginning
  Eigen::VectorXd start, start_rate;
  struct Force {  // of an actuator
    Place place;
    Expression expression;
    double home = 0;             // value of the actuator there [m], [rad]
    std::vector<int> variables;  // of the expression, beside its own three: 2 i the value of actuator i, 2 i + 1 its rate
  };
  std::vector<std::optional<Force>> forces;  // one an actuator; nothing: it exerts none
  bool until_singularity = false, until_limit = false;
  std::string description;
};
// Nothing, told, when something is wrong.
std::optional<Forces> read_forces(const Value& motion, Place place, const MechanismPart& mechanism, const Movables& movables,
                                  const Reader& reader);
// The motion that follows, at these times. Nothing, told, when it cannot begin, or, cut off, has too few samples.
std::optional<Motion> forced(const Forces& forces, const Load& load, std::vector<double> times, const mechanics::Machine& machine,
                             Diagnostics& diagnostics);
// Keeps the first samples of a motion. False, told, when they make none.
bool cut_off(Motion& motion, std::size_t samples, Place place, Diagnostics& diagnostics);
// Cuts a motion of coordinates off at the first singular surface. False, told, when too few samples remain.
bool end_at_singularity(Motion& motion, const mechanics::Machine& machine, Place place, Diagnostics& diagnostics);

// A coordinate that is named but cannot be given: unknown, or dependent. `keys`: what may be named, in words; else `known` is listed.
void refuse_coordinate(Place place, const std::string& name, const MechanismPart& mechanism, const std::vector<std::string>& known,
                       const std::string& where, Diagnostics& diagnostics, const std::string& keys = {});

// [load], but for its samples: what a motion from forces feels must be known at any time before there is one.
struct LoadPart {
  struct Component {
    std::string key;
    Place place;
    Expression expression;
  };
  Load load;
  std::vector<std::optional<Component>> components;  // force, moment; nothing: zero, or wrong
};
LoadPart read_load(const Entry* entry, const Reader& reader);
// The load at every sample; told where it has no finite value.
Load sampled(LoadPart part, const std::vector<double>& time, Diagnostics& diagnostics);

// [drive], and [limits].
std::vector<mechanics::DriveTrain> read_drives(const Entry* entry, const MechanismPart& mechanism, const Reader& reader);
// What to write so that an actuator has a motor: "add to [drive], or to [drive.q], lead = "5 mm"".
std::string how_to_give_motor(const Actuator& a);
mechanics::MotionLimits read_limits(const Entry* entry, const MechanismPart& mechanism, const Reader& reader);
// A quantity from `least` to `most` `unit`, SI; told when it is not.
std::optional<double> read_within(const Entry& entry, double least, double most, const std::string& unit, const std::string& hint,
                                  const Reader& reader);

// A table that kinds of sections may need, and where it stands; nullptr: it does not.
struct GivenTable {
  std::string name;
  const Entry* entry;
};

// A section whose kind cannot be read keeps none. `drives`: what [drive] says.
std::vector<Section> read_sections(const Entry* entry, Kinds kinds, const std::optional<Interval>& interval, const MechanismPart& mechanism,
                                   std::span<const GivenTable> tables, const std::vector<mechanics::DriveTrain>& drives,
                                   const Reader& reader);

// What one number of the report may be made of.
struct Measurable {
  const std::vector<Section>& sections;
  const std::optional<Topology>& topology;
  const std::optional<Interval>& interval;
  const std::vector<mechanics::DriveTrain>& drives;
  Kinds kinds;  // all that a section could be of
};
// "max(abs(actuator_force))", "at(l1, 2.5 s)", "mobility.redundant". Nothing, told, when there is no such thing in this report; a thing
// without columns and quantity when the mechanism is unknown, so that it cannot be judged.
std::optional<Measured> read_measured(const Value& value, const Measurable& measurable, const Reader& reader);
bool judged(const Measured& m);

std::vector<Check> read_checks(const Entry* entry, const Measurable& measurable, const Reader& reader);

// The tables of an array of tables, [[name]]; a single table or anything else is reported.
std::vector<const Value*> tables_of(const Entry* entry, const std::string& name, const Reader& reader);

// The value of `entry` when it is a table, else reported and nullptr.
const Value* table_of(const Entry* entry, const std::string& name, const Reader& reader);

// Reports the first time at which a curve has no finite value, rate or acceleration. True when it is finite.
bool finite(const Jet<double>& x, double t, Place place, const std::string& what, Diagnostics& diagnostics);

}  // namespace pmreport::scenario
