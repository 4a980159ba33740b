// Forward displacement: the coordinates at which the actuators have given values.
#pragma once

#include <core/mechanics/model/outcome.hpp>
#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

struct ForwardSolution {
  Outcome outcome = Outcome::not_converged;
  SmallVector coordinates;  // the best found
  double residual = 0;      // largest actuator deviation, [m] or [rad]
  int iterations = 0;       // evaluations of `place`
  std::string why;          // a sentence when not good
};

// Newton's method on l(q) = l*, l* the actuators:
//     J dq = l* - l(q),   J = dl/dq from the exact partials of `place`              (1)
// A placement with partials costs several plain ones, so J^-1 is kept and improved by Broyden's rank-one update (1965), after a step dq
// that changed l by dl,
//     J^-1 += (dq - J^-1 dl) dq^T J^-1 / (dq^T J^-1 dl)                             (2)
// so that J^-1 dl = dq, while the error falls fast, and taken anew from the partials when it does not. A step is at most a tenth of the
// mechanism's size, or 0.3 rad, and halved while the pose it leads to cannot be assembled. The guess tells the assembly mode: the solution
// must have det G of the same sign, as far as rounding lets it be known. Keeps its buffers: make one a thread and reuse it.
class ForwardSolver {
 public:
  explicit ForwardSolver(const Machine& machine);  // which must outlive it

  // `actuators`: l* [m], [rad]; `guess`: coordinates [m], [rad]; both dof long. Outcomes: good, not_converged (then the best met is given),
  // singular (guess or solution), other_assembly_mode. Throws nothing.
  ForwardSolution solve(const SmallVector& actuators, const SmallVector& guess);

  static constexpr double tolerance = 1e-14;  // of the actuators, relative to the mechanism's size: a few roundings
  static constexpr int max_iterations = 100;

 private:
  bool place(const SmallVector& q);  // fills values_; false where q cannot be assembled
  SmallVector error(const SmallVector& actuators) const;
  SmallMatrix inverse_jacobian(const SmallVector& q);
  int side() const;
  ForwardSolution& undetermined(ForwardSolution& out, const SmallVector& q) const;

  const Machine& machine_;
  double size_ = 0, length_;
  SmallVector largest_step_;
  std::vector<double> partials_, values_;
};

// Continuation: solves a sequence of actuator values, each from the solution before it, the first from `start`. Stops at the first that
// fails.
std::vector<ForwardSolution> follow_actuators(const Machine& machine, const std::vector<Eigen::VectorXd>& actuators,
                                              const Eigen::VectorXd& start);

}  // namespace pmreport::mechanics
