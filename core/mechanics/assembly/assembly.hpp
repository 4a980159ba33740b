// Forward displacement, all of it: every real assembly mode, that is, every pose in which the actuators have given values.
#pragma once

#include <core/mechanics/model/machine.hpp>
#include <core/mechanics/model/state.hpp>

#include <cstdint>
#include <memory>
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
  int reached_by_starts = 0;  // how many of the random starts ended here
};

struct WorkingMode {  // one word for each choice of working mode
  std::unique_ptr<Machine> machine;
  std::string name;  // "slider 2 below, slider 3 below": what differs from the machine asked about; empty: nothing
};

struct AssemblyModes {
  std::vector<WorkingMode> words;   // the machine's own first; combinations that the mechanism refuses are left out
  std::vector<AssemblyMode> modes;  // nearest to the reference pose first
  // How they were found, for an honest statement: no number of starts proves that there are no more.
  int starts = 0, arrivals = 0;  // of Newton's method from random poses, and how many reached a mode
  int curves = 0;                // curves followed
  int last_new = 0;              // the start that was the last to find a mode not known by then; 0: the reference and the curves found all
  std::int64_t placements = 0;
  bool complete_search = true;  // false: stopped at the most modes that are kept; there may be a continuum of them
};

struct AssemblyOptions {
  bool working_modes = true;  // with every word of every choice of working mode, else the machine's own
  int quiet_arrivals = 500;   // arrivals at modes known before that end the search, at least; twelve for each mode known, if that is more
  int most_starts = 4000;
  std::size_t most_modes = 256;
  std::uint64_t seed = 1;
};

// Finds them all in practice, without a proof. Two ways work together. Newton's method starts from random poses of the whole space. From
// each mode found, each actuator in turn is released and the curve of poses that the others still allow is followed by prediction and
// correction: wherever the released actuator passes its value, there is a mode. Where a curve leaves the poses that can be assembled it
// goes on in another working mode. Modes with basins too small for any start to hit are found in this way; the starts in turn find curves
// that no known mode lies on. The same numbers on every run. `actuators` [m], [rad]; `reference`: a pose from which the distances count, by
// its coordinates [m], [rad].
AssemblyModes find_assembly_modes(const Machine& machine, const Eigen::VectorXd& actuators, const Eigen::VectorXd& reference,
                                  const AssemblyOptions& options = {});

// Between two poses of the platform: sqrt(|dp|^2 + (length * angle)^2) [m], dp the way of its reference point, angle the turn from one
// orientation to the other.
double distance(const Machine& machine, const Pose& a, const Pose& b, double length);

}  // namespace pmreport::mechanics
