// The two ways of walking to an assembly mode: Newton's method from anywhere, and along a curve from a mode already known.
#pragma once

#include <core/mechanics/assembly/walk.hpp>

#include <functional>

namespace pmreport::mechanics {

struct Arrival {  // of Newton's method
  bool found = false;
  Site site;  // the mode
};

// Newton on error(u) = 0 from `u`; where the slope has lost rank, by steps of least norm. No step is longer than `reach` in any number;
// from afar the steps wander rather than descend, which costs little and gets past the minima of the error that are no mode.
Walk<Arrival> newton(Halt& halt, std::size_t word, SmallVector u, double reach, int max_steps);

// Where the actuators are held but for moving in one common way, say only one of them, or all in given proportions, a mechanism has one
// degree of freedom: its poses are curves. All modes at which they pass their targets lie on such curves.
struct Release {
  std::size_t number = 0;  // for reference
  Eigen::Index lead = 0;   // the actuator that moves most
  SmallVector share;       // of each actuator in the motion, that of the lead is 1
};

struct SolutionCurve {  // one of them, as it is to be followed
  std::size_t word = 0;
  const Release* release = nullptr;
  SmallVector start;    // a pose on the curve, or close to it
  SmallVector tangent;  // which way to go; of any length
};

struct SolutionCurveEnd {
  enum class How {
    closed,        // came back to its start
    out_of_reach,  // the pose cannot be assembled any further: two words of the working mode meet there
    far,           // left for infinity
    cut,           // went on for too long, or no step along it was short enough
    lost           // never got on the curve
  } how = How::lost;
  SmallVector u, tangent, bend;  // the last pose, and du/ds and d2u/ds2 there
  int steps = 0;
};

// Follows the curve. `met` is told every mode passed; the curve counts as closed when it answers that this is where the trace began.
Walk<SolutionCurveEnd> trace(Halt& halt, SolutionCurve curve, const AssemblyTarget& target, std::function<bool(const Site&)> met);

}  // namespace pmreport::mechanics
