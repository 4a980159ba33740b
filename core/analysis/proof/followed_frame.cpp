#include <core/analysis/proof/followed_frame.hpp>

#include <core/linear/square.hpp>
#include <core/program/derivative.hpp>

#include <cmath>
#include <numeric>

namespace pmreport::analysis {

namespace {

// Newton's method from nearby: a longer step leads elsewhere; a shorter one leaves an error of its square.
constexpr double longest_step = 0.25, last_step = 1e-8;
constexpr int most_steps = 8;

using program::Operation;

program::Program with_choices(const program::Program& actuators, int& choices, int& kinks) {
  std::vector<program::Step> steps(actuators.steps().begin(), actuators.steps().end());
  std::vector<int> outputs(actuators.outputs().begin(), actuators.outputs().end()), masks_of_kinks;
  const auto add = [&](const program::Step& s) {
    steps.push_back(s);
    return static_cast<int>(steps.size()) - 1;
  };
  const int one = add({Operation::constant, 0, 0, 0, 1}), zero = add({Operation::constant, 0, 0, 0, 0});
  const auto tell = [&](int mask) { outputs.push_back(add({Operation::choose, mask, one, zero, 0})); };
  for (std::size_t i = 0; i < actuators.steps().size(); ++i) {
    const program::Step s = steps[i];
    if (s.operation == Operation::choose) tell(s.a), ++choices;
    if (s.operation == Operation::atan2) {  // whole only where x > 0 or y is not 0
      const int above = add({Operation::less, zero, s.a, 0, 0}), below = add({Operation::less, s.a, zero, 0, 0}),
                ahead = add({Operation::less, zero, s.b, 0, 0});
      tell(add({Operation::either, ahead, add({Operation::either, above, below, 0, 0}), 0, 0})), ++choices;
    }
    if (s.operation == Operation::min || s.operation == Operation::max) masks_of_kinks.push_back(add({Operation::less, s.a, s.b, 0, 0}));
    if (s.operation == Operation::abs) masks_of_kinks.push_back(add({Operation::less, s.a, zero, 0, 0}));
  }
  for (const int mask : masks_of_kinks) tell(mask), ++kinks;
  return program::Program(steps, actuators.inputs(), outputs);
}

std::vector<int> from_to(std::size_t first, int count) {
  std::vector<int> out(static_cast<std::size_t>(count));
  std::iota(out.begin(), out.end(), static_cast<int>(first));
  return out;
}

SmallVector middles(const mechanics::Bounded* of, int count, program::Bounds mechanics::Bounded::*part) {
  SmallVector out(count);
  for (int i = 0; i < count; ++i) out(i) = (of[i].*part).middle();
  return out;
}

}  // namespace

ActuatorGeometry::ActuatorGeometry(const program::Program& geometry, std::size_t first)
    : dof(geometry.inputs()),
      values(with_choices(geometry.slice(from_to(first, dof)), choices, kinks)),
      partials(program::partials(values, from_to(0, dof))),
      in_time(program::in_time(values, 2)) {
  // The rate of l_k has the partials sum_i d2l_k / dq_j dq_i q_i' = J'_kj.
  const int all = static_cast<int>(outputs());
  std::vector<int> wanted = from_to(static_cast<std::size_t>(dof), choices + kinks);
  for (int k = 0; k < dof; ++k)
    for (int j = 0; j < dof; ++j) wanted.push_back(2 * all + (all + k) * dof + j);
  turning = program::partials(program::in_time(values, 1), from_to(0, dof)).slice(wanted);
}

FrameFinder::FrameFinder(const ActuatorGeometry& geometry, const SmallVector& sizes)
    : geometry_(geometry),
      sizes_(sizes),
      values_(geometry.values),
      partials_(geometry.partials),
      out_(geometry.partials.outputs().size()) {}

std::optional<MovingFrame> FrameFinder::at(double t, const mechanics::Bounded* prescribed, SmallVector q) {
  const int m = geometry_.dof;
  const SmallVector wanted = middles(prescribed, m, &mechanics::Bounded::value);
  MovingFrame frame{t, SmallVector(), SmallVector(), SmallMatrix(m, m)};
  for (int k = 0; k < most_steps; ++k) {
    partials_.run({q.data(), static_cast<std::size_t>(m)}, out_);
    SmallMatrix jacobian(m, m);
    for (int i = 0; i < m; ++i)
      for (int j = 0; j < m; ++j) jacobian(i, j) = out_[geometry_.outputs() + static_cast<std::size_t>(i * m + j)];
    frame.inverse = linear::inverse(jacobian);
    const SmallVector step = frame.inverse * (wanted - Eigen::Map<const Eigen::VectorXd>(out_.data(), m));
    const double length = (step.array() / sizes_.array()).abs().maxCoeff();
    if (!(length < longest_step) || !step.allFinite()) return std::nullopt;
    q += step;
    if (length < last_step) break;
  }
  frame.origin = q;
  frame.velocity = frame.inverse * middles(prescribed, m, &mechanics::Bounded::rate);
  if (!frame.velocity.allFinite() || !frame.inverse.allFinite()) return std::nullopt;
  return frame;
}

double FrameFinder::deviation(const MovingFrame& frame, const SmallVector& coordinates, const mechanics::Bounded* prescribed) {
  const int m = geometry_.dof;
  values_.run({coordinates.data(), static_cast<std::size_t>(m)}, {out_.data(), geometry_.outputs()});
  const SmallVector error =
      frame.inverse * (Eigen::Map<const Eigen::VectorXd>(out_.data(), m) - middles(prescribed, m, &mechanics::Bounded::value));
  return (error.array() / sizes_.array()).abs().maxCoeff();
}

}  // namespace pmreport::analysis
