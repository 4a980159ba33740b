#include <core/mechanics/displacement/displacement.hpp>

#include <core/assertion.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>
#include <core/mechanics/model/tangent.hpp>

#include <fmt/core.h>

#include <cmath>
#include <limits>

namespace pmreport::mechanics {

ForwardSolver::ForwardSolver(const Machine& machine)
    : machine_(machine),
      length_(characteristic_length(machine)),
      partials_(machine.layout().size() * machine.components(PM_PARTIALS)),
      values_(machine.layout().size()) {
  // The size of a mechanism: how far its joints are apart at home.
  const Topology& t = machine.topology();
  for (int i = 0; i < static_cast<int>(t.joints.size()); ++i)
    size_ = std::max(size_, (machine.centre(machine.home_pose(), i) - machine.centre(machine.home_pose(), 0)).norm());
  if (size_ == 0) size_ = 1;  // all joints in one point: a size says nothing
  largest_step_.resize(machine.dof());
  for (int i = 0; i < machine.dof(); ++i) {
    const bool length = t.coordinates[static_cast<std::size_t>(i)].sense() == Sense::linear;
    largest_step_(i) = length ? 0.1 * size_ : 0.3;
  }
}

bool ForwardSolver::place(const SmallVector& q) { return machine_.place(PM_VALUE, 1, q.data(), values_.data()) == PM_OK; }

SmallVector ForwardSolver::error(const SmallVector& actuators) const {
  return actuators - Eigen::Map<const Eigen::VectorXd>(values_.data() + machine_.layout().actuator(0), machine_.dof());
}

SmallMatrix ForwardSolver::inverse_jacobian(const SmallVector& q) {
  const int m = machine_.dof();
  machine_.place(PM_PARTIALS, 1, q.data(), partials_.data());
  SmallMatrix j(m, m);
  const double* at = partials_.data() + machine_.layout().actuator(0) * static_cast<std::size_t>(1 + m);
  for (int i = 0; i < m; ++i)
    for (int k = 0; k < m; ++k) j(i, k) = at[i * (1 + m) + 1 + k];
  return linear::inverse(j);
}

// The side of the singular surface that the pose last placed is on.
int ForwardSolver::side() const { return side_of(machine_.jacobian(values_.data()).matrix, length_); }

// No step leads on from q: either the actuators do not determine the pose, or the coordinates do not chart it.
ForwardSolution& ForwardSolver::undetermined(ForwardSolution& out, const SmallVector& q) const {
  const auto fault = chart_fault(machine_, q, length_);
  out.outcome = Outcome::singular;
  out.why = fault ? in_words(machine_, *fault) : "the actuators do not determine the pose there (singular)";
  return out;
}

ForwardSolution ForwardSolver::solve(const SmallVector& actuators, const SmallVector& guess) {
  PMREPORT_ASSERT(actuators.size() == machine_.dof() && guess.size() == machine_.dof(),
                  "there are as many of either as degrees of freedom");
  ForwardSolution out{Outcome::not_converged, guess, std::numeric_limits<double>::infinity(), 0, ""};
  SmallVector q = guess;
  if (!place(q)) {
    out.why = "the guess itself cannot be assembled";
    return out;
  }
  const int side_of_guess = side();
  SmallVector e = error(actuators);
  SmallMatrix inverse = inverse_jacobian(q);
  bool fresh = true;  // inverse_jacobian belongs to q
  while (true) {
    const double residual = e.lpNorm<Eigen::Infinity>();
    if (residual < out.residual) {
      out.residual = residual;
      out.coordinates = q;
    }
    if (residual <= tolerance * size_) break;
    if (out.iterations >= max_iterations) {
      out.why = fmt::format("no pose near the guess has these actuator values (closest: {:.3g} off after {} iterations)", out.residual,
                            out.iterations);
      return out;
    }
    SmallVector step = inverse * e;  // (1)
    const double excess = (step.array() / largest_step_.array()).abs().maxCoeff();
    if (!(excess < 1e12)) return undetermined(out, q);
    if (excess > 1) step /= excess;
    int halvings = 0;
    while (!place(q + step) && ++halvings < 30) step *= 0.5;
    if (halvings == 30) {
      out.why = "the way to these actuator values leaves the poses that can be assembled";
      return out;
    }
    ++out.iterations;
    q += step;
    const SmallVector next = error(actuators);
    const double now = next.lpNorm<Eigen::Infinity>();
    // The last step of a converging sequence only stirs the rounding: what cannot improve any more has converged.
    if (fresh && now >= residual && residual <= 100 * tolerance * size_) break;
    if (now > 0.25 * residual) {
      inverse = inverse_jacobian(q);
      fresh = true;
    } else {
      const SmallVector seen = inverse * (e - next);  // J^-1 dl; (2)
      const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 6> row = step.transpose() * inverse;
      inverse += (step - seen) * row / step.dot(seen);
      fresh = false;
    }
    e = next;
  }
  if (out.coordinates != q) place(out.coordinates);
  const int side_of_solution = side();
  if (side_of_guess == 0 || side_of_solution == 0) {
    out.outcome = Outcome::singular;
    out.why = side_of_guess == 0 ? "the guess is a singular pose, whose assembly mode cannot be told"
                                 : "the solution is a singular pose: the actuators do not determine it";
  } else if (side_of_solution == side_of_guess) {
    out.outcome = Outcome::good;
  } else {
    out.outcome = Outcome::other_assembly_mode;
    out.why = "the solution lies beyond a singular surface (det G has changed its sign): it belongs to another assembly mode";
  }
  return out;
}

std::vector<ForwardSolution> follow_actuators(const Machine& machine, const std::vector<Eigen::VectorXd>& actuators,
                                              const Eigen::VectorXd& start) {
  ForwardSolver solver(machine);
  std::vector<ForwardSolution> out;
  SmallVector guess = start;
  for (const auto& l : actuators) {
    out.push_back(solver.solve(l, guess));
    if (out.back().outcome != Outcome::good) break;
    guess = out.back().coordinates;
  }
  return out;
}

}  // namespace pmreport::mechanics
