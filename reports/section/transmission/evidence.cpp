// That the numbers are right, shown by ways that share little with them.
#include <reports/section/common/words/words.hpp>
#include <reports/section/transmission/transmission.hpp>

#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/model/effort.hpp>

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::section {

using document::Evidence;
using Eigen::VectorXd;
using mechanics::Machine;
using mechanics::TransmissionIndices;
using mechanics::Vector6d;

namespace {

constexpr int of_motion = 8;        // samples that are compared, spread evenly
constexpr double comparable = 1e4;  // condition number up to which columns of the inverse keep their digits
// Of the characteristic length that the platform moves for a difference, until a smaller step changes it no more: near a singular pose the
// largest would go beyond what is smooth, and of the least only rounding is left.
constexpr double steps[] = {1e-2, 1e-3, 1e-4, 1e-5};
constexpr double settled = 1e-8;  // change by the last step, relative, from which a difference is called known
constexpr double differences = 1e-7;
constexpr double partials = 1e-9;  // times the condition, at most `comparable`, of rounding: 1e-12

// Poses of the motion, then those that were asked for; home where there is neither.
std::vector<VectorXd> compared_poses(const Analysis& a, const TransmissionOptions& r) {
  std::vector<VectorXd> out;
  std::vector<int> good;
  for (int k = 0; k < a.samples(); ++k)
    if (a.outcome(k) == Outcome::good) good.push_back(k);
  const int n = static_cast<int>(good.size()), count = std::min(n, of_motion);
  for (int i = 0; i < count; ++i)
    out.push_back(a.trajectory().value.row(good[static_cast<std::size_t>((i + 0.5) * n / count)]).transpose());
  out.insert(out.end(), r.poses.begin(), r.poses.end());
  if (out.empty()) out.push_back(a.machine().home());
  return out;
}

double size_of_twist(const Vector6d& twist, double length) { return std::hypot(twist.head<3>().norm(), length * twist.tail<3>().norm()); }

// The platform's pose as a displacement from another: (shift; rotation vector).
Vector6d displacement(const Machine& m, const mechanics::Pose& from, const mechanics::Pose& to) {
  const int platform = m.topology().platform;
  const Eigen::AngleAxisd turn(m.rotation(to, platform) * m.rotation(from, platform).transpose());
  return (Vector6d() << m.origin(to, platform) - m.origin(from, platform), turn.angle() * turn.axis()).finished();
}

Vector6d unknown() { return Vector6d::Constant(std::numeric_limits<double>::quiet_NaN()); }

// The output twist by moving the actuator by h and following the platform, central differences of fourth order; NaN where forward
// displacement does not arrive.
Vector6d difference(const Machine& m, mechanics::ForwardSolver& solver, const VectorXd& q, int actuator, double h) {
  const mechanics::Pose here = m.pose({q.data(), static_cast<std::size_t>(q.size())});
  mechanics::SmallVector l(m.dof());
  for (int i = 0; i < m.dof(); ++i) l(i) = here.numbers[m.layout().actuator(i)];
  const auto moved = [&](double by) -> Vector6d {
    mechanics::SmallVector target = l;
    target(actuator) += by;
    const mechanics::ForwardSolution s = solver.solve(target, q);
    if (s.outcome != Outcome::good) return unknown();
    return displacement(m, here, m.pose({s.coordinates.data(), static_cast<std::size_t>(s.coordinates.size())}));
  };
  return (8 * (moved(h) - moved(-h)) - (moved(2 * h) - moved(-2 * h))) / (12 * h);
}

// The difference that a smaller step changes least; NaN where that is not small. `size`: of the twist [m], by unit rate.
Vector6d twist_by_moving(const Machine& m, mechanics::ForwardSolver& solver, const VectorXd& q, int actuator, double length, double size) {
  Vector6d before = unknown(), best = unknown();
  double least = settled;
  for (const double step : steps) {
    const Vector6d d = difference(m, solver, q, actuator, step * length / size);
    if (const double change = size_of_twist(d - before, length) / size; change < least) least = change, best = d;
    before = d;
  }
  return best;
}

struct Compared {
  int compared = 0, twists = 0, telescopes = 0;
  double by_moving = 0, by_partials = 0, rate = 0;
};

Compared compare(const Analysis& a, const TransmissionOptions& r) {
  const Machine& m = a.machine();
  const mechanics::Transmission& t = *a.transmission();
  const double length = a.length();
  mechanics::ForwardSolver solver(m);
  Compared out;
  for (const VectorXd& q : compared_poses(a, r)) {
    const auto at = t.at({q.data(), static_cast<std::size_t>(q.size())});
    if (!at || !(at->condition < comparable)) continue;
    const mechanics::State state = mechanics::state_at_rest(m, q);
    if (state.status != PM_OK) continue;
    const mechanics::Tangent tangent = mechanics::tangent(m, state);
    const Eigen::MatrixXd platform = tangent.bodies.middleRows<6>(6 * m.topology().platform - 6);
    const Eigen::MatrixXd by_partials = platform * Eigen::MatrixXd(tangent.actuators).inverse();
    for (int i = 0; i < m.dof(); ++i) {
      const TransmissionIndices::OfActuator& index = at->actuators[static_cast<std::size_t>(i)];
      const double size = size_of_twist(index.twist, length);
      ++out.compared;
      // What is no number must not pass for a small one.
      const double partial = size_of_twist(by_partials.col(i) - index.twist, length) / size;
      if (!(partial <= out.by_partials)) out.by_partials = partial;
      if (t.paths().drives[static_cast<std::size_t>(i)].telescope)
        out.rate = std::max(out.rate, std::abs(std::abs(index.force.dot(index.velocity)) - 1)), ++out.telescopes;
      const double off = size_of_twist(twist_by_moving(m, solver, q, i, length, size) - index.twist, length) / size;
      if (std::isfinite(off)) out.by_moving = std::max(out.by_moving, off), ++out.twists;
    }
  }
  return out;
}

Evidence zero_at_crossings(const Analysis& a) {
  const std::string claim = "The indices vanish where the motion crosses a singular surface",
                    how = "least output transmission, or cosine, at the pose of the crossing";
  int met = 0;
  double largest = 0;
  for (const Crossing& c : a.crossings()) {
    if (c.what != Crossing::What::surface) continue;
    const auto at = a.transmission()->at({c.coordinates.data(), static_cast<std::size_t>(c.coordinates.size())});
    if (!at) continue;
    double least = 1;
    for (int i = 0; i < a.machine().dof(); ++i) {
      const TransmissionIndices::OfActuator& index = at->actuators[static_cast<std::size_t>(i)];
      for (const double x : {index.output, index.cosine})
        if (std::isfinite(x)) least = std::min(least, x);
    }
    largest = std::max(largest, least), ++met;
  }
  constexpr double found_to = 1e-6;  // a crossing is found to the last digits of its time, a touch to half of them
  if (met == 0) return Evidence::without_value(document::Verdict::not_applicable, claim, how, "it crosses none");
  return {claim, fmt::format("{}, at {}", how, plural(met, "crossing")), largest, found_to, ""};
}

}  // namespace

document::Proof transmission_proof(const Analysis& a, const TransmissionOptions& r) {
  const Compared c = compare(a, r);
  document::Proof proof;
  const std::string moving = "Output twists are what the platform does when one actuator moves",
                    moving_how =
                        "columns of the inverse of the mechanism's own G against differences of poses that forward displacement finds, an "
                        "actuator moved to both sides; relative",
                    same = "Output twists follow from the geometry as well",
                    same_how = "the same columns against the exact partials of the platform's pose and of the actuators; relative";
  if (c.compared > 0) {
    if (c.twists > 0)
      proof.lines.push_back(
          {moving, fmt::format("{} ({} of {})", moving_how, c.twists, plural(c.compared, "twist")), c.by_moving, differences, ""});
    else
      proof.lines.push_back(Evidence::not_examined(moving, moving_how, "no difference settled at any step"));
    proof.lines.push_back({same, same_how, c.by_partials, partials, ""});
  } else {
    const std::string reason = "no pose that was looked at is regular enough to compare";
    proof.lines.push_back(Evidence::not_examined(moving, moving_how, reason));
    proof.lines.push_back(Evidence::not_examined(same, same_how, reason));
  }
  if (c.telescopes > 0)
    proof.lines.push_back({"The ends of each telescopic drive part at the rate of its actuator",
                           "velocity of the far end from the near one, along the slide, under the output twist, against a unit rate",
                           c.rate, partials, ""});
  proof.lines.push_back(zero_at_crossings(a));
  return proof;
}

}  // namespace pmreport::section
