// The trajectory of a motion under given forces.
#pragma once

#include <core/mechanics/forward_dynamics/forward_dynamics.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>

namespace pmreport::mechanics {

struct Forced {
  Trajectory trajectory;            // all times; without a pose beyond the end
  std::size_t reached = 0;          // samples up to the end
  Outcome outcome = Outcome::good;  // what ends it
};

// By forward dynamics (forward_dynamics.hpp), which says when it throws MechanismError. `machine`, and what the problem's functions refer
// to, must outlive the trajectory.
Forced forced(const Machine& machine, const ForwardProblem& problem);

}  // namespace pmreport::mechanics
