// Forward displacement, all of it: every real assembly mode, that is, every pose in which the actuators have given values.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/model/state.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct AssemblyMode {
  std::size_t word = 0;         // of the working mode: index into AssemblyModes::words
  Eigen::VectorXd coordinates;  // [m], [rad]; angles between half a turn either way
  Pose pose;
  double determinant = 0;     // of G
  double residual = 0;        // by substitution: largest actuator deviation, of the mechanism's size or [rad]
  double gap = 0;             // joint centres as both bodies carry them, of the mechanism's size
  double misalignment = 0;    // likewise of joint axes [rad]
  double distance = 0;        // from the reference pose [m], see distance()
  bool within_limits = true;  // strokes and joint limits
  bool twofold = false;       // two modes in one: they have met on a singular surface
  bool chart = false;         // the coordinates are singular here, as angles may be; the mechanism is not
  int reached_by_starts = 0;  // how many of the random starts ended here
};

// Poses that all have the actuator values and go over into one another: with its actuators held the mechanism moves through them.
struct ModeContinuum {
  std::size_t word = 0;                      // of the working mode
  int dimension = 1;                         // 1: a curve of poses
  std::vector<Eigen::VectorXd> coordinates;  // of some of its poses [m], [rad]: of a curve one after the other, angles going on past a turn
  std::vector<Pose> poses;
  bool closed = false;                    // a curve that comes back to itself
  bool whole = true;                      // a curve that was followed to its ends
  double residual = 0;                    // as of a mode, largest of its poses
  double distance = 0;                    // of the pose nearest to the reference [m]
  double extent = 0;                      // largest distance of a pose from that one [m]
  std::size_t nearest = 0, farthest = 0;  // the two of `extent`, indices of poses
  int reached_by_starts = 0;
};

// A pose that closes all joints with the actuator values, of which `place` has the platform nowhere: a platform with fewer coordinates than
// six may stand otherwise than they say.
struct FurtherPose {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of the platform [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double distance = 0;   // from the reference pose [m]
  double error = 0;      // largest of the equations of joints and actuators, lengths by the mechanism's size
  bool isolated = true;  // else the platform moves with its actuators held
};

struct FurtherModes {              // what a search on the joints alone has brought
  std::vector<FurtherPose> poses;  // one for each place of the platform, nearest to the reference first
  int starts = 0, arrivals = 0;    // of Newton's method, and how many closed all joints
  int seen = 0;                    // how many of the modes they arrived at
  int missed = 0;                  // modes among them that `place` can express, and that nothing else had found
};

struct WorkingMode {  // one word for each choice of working mode
  std::unique_ptr<Machine> machine;
  std::string name;  // "slider 2 below, slider 3 below": what differs from the machine asked about; empty: nothing
};

struct AssemblyModes {
  std::vector<WorkingMode> words;       // the machine's own first; combinations that the mechanism refuses are left out
  std::vector<AssemblyMode> modes;      // those that are isolated, nearest to the reference pose first
  std::vector<ModeContinuum> continua;  // likewise
  // How they were found, for an honest statement: no number of starts proves that there are no more.
  int starts = 0, arrivals = 0;  // of Newton's method from random poses, and how many reached a mode
  int curves = 0;                // curves followed
  int last_new = 0;              // the start that was the last to find a mode not known by then; 0: the reference and the curves found all
  int curves_cut = 0;            // curves given up before their end: after too many steps, or where no step was short enough
  int curves_far = 0;            // curves left where they went off, many times the size of the mechanism
  int edges = 0;                 // ends of reach that curves were led across, into another working mode
  std::int64_t placements = 0;
  std::optional<FurtherModes> further;                                                 // nothing: the joints alone were not searched
  enum class Ended { quiet, most_starts, most_modes, no_start } ended = Ended::quiet;  // no_start: no more poses that can be assembled
  bool complete_search() const { return ended != Ended::most_modes; }
};

struct AssemblyOptions {
  bool working_modes = true;  // with every word of every choice of working mode, else the machine's own
  int quiet_arrivals = 500;   // arrivals at what was known before that end the search, at least; twelve for each mode, if that is more
  int most_starts = 4000;
  std::size_t most_modes = 256;  // and continua
  int joint_starts = 100;  // of the search on the joints alone; none where six coordinates say all of a platform, or words are left out
  std::uint64_t seed = 1;
};

// Finds them all in practice, without a proof. Two ways work together. Newton's method starts from random poses of the whole space. From
// each mode found, each actuator in turn is released and the curve of poses that the others still allow is followed by prediction and
// correction: wherever the released actuator passes its value, there is a mode. Where a curve leaves the poses that can be assembled it
// goes on in another working mode. Modes with basins too small for any start to hit are found in this way; the starts in turn find curves
// that no known mode lies on. A third way, further.hpp, knows bodies and joints alone: it finds what `place` cannot express, and what it
// can express but Newton's method does not come to, as close to the ends of reach. Where the actuators have lost rank at a mode, it is told
// from a continuum of modes: continuum.hpp. The same numbers on every run. `actuators` [m], [rad]; `reference`: a pose from which the
// distances count, by its coordinates [m], [rad].
AssemblyModes find_assembly_modes(const Machine& machine, const Eigen::VectorXd& actuators, const Eigen::VectorXd& reference,
                                  const AssemblyOptions& options = {});

// Between two poses of the platform: sqrt(|dp|^2 + (length * angle)^2) [m], dp the way of its reference point, angle the turn from one
// orientation to the other.
double distance(const Machine& machine, const Pose& a, const Pose& b, double length);

}  // namespace pmreport::mechanics
