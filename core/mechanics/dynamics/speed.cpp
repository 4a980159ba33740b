#include <core/mechanics/dynamics/speed.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

namespace pmreport::mechanics {
namespace {

// Newton's method for a root that it nears from one side, by a curve that bends away from zero there: every step falls short of the root.
// It has arrived when rounding takes the next step back, or nowhere.
template <class Step>
double newton(double x, Step step) {
  double direction = 0;
  for (;;) {
    const double next = x + step(x);
    if (next == x || (next - x) * direction < 0) return x;
    direction = next - x;
    x = next;
  }
}

// Smallest x > 0 with |x + c x^3| = 1: the power s a + s^3 b, a > 0, over its limit L, with s = x L / a and c = b L^2 / a^3.
//
//   c >= 0       it rises for ever; the one root of c x^3 + x - 1 is not above min(1, c^(-1/3)), and the cubic is convex
//   c <= -4/27   it never climbs above 1: its summit is 2/3 x, at x = (-3 c)^(-1/2); it falls through -1 at the one root of
//                |c| x^3 - x - 1, which is convex there, and not above |c|^(-1/3) + |c|^(-1/2)
//   else         it climbs through 1 before its summit: smallest root of x - |c| x^3 - 1, which is concave, and not positive at 1
double first_unit(double c) {
  if (c >= 0) return newton(std::min(1.0, 1 / std::cbrt(c)), [c](double x) { return -(c * x * x * x + x - 1) / (3 * c * x * x + 1); });
  const double b = -c;
  if (27 * b >= 4)
    return newton(1 / std::cbrt(b) + 1 / std::sqrt(b), [b](double x) { return -(b * x * x * x - x - 1) / (3 * b * x * x - 1); });
  // Beyond the summit, where rounding may throw a step when the root lies close to it, Newton's method has nothing to say.
  const double summit = 1 / std::sqrt(3 * b);
  const double root = newton(1.0, [b, summit](double x) { return x < summit ? (1 - x + b * x * x * x) / (1 - 3 * b * x * x) : 0; });
  return std::min(root, summit);
}

}  // namespace

// With u = s^2 the force is on a straight line: it leaves [-limit, limit] at the end towards which it moves.
double speed_by_force(double rest, double inertia, double limit) {
  if (std::isnan(rest) || std::isnan(inertia)) return nan;
  if (std::abs(rest) > limit) return 0;
  if (inertia == 0) return infinity;
  return std::sqrt((limit - std::copysign(1.0, inertia) * rest) / std::abs(inertia));
}

double speed_by_power(double rest, double inertia, double rate, double limit) {
  const double a = std::abs(rate * rest), b = (rest < 0 ? -inertia : inertia) * std::abs(rate);
  if (std::isnan(a) || std::isnan(b)) return nan;
  const double by_inertia = b != 0 ? std::cbrt(limit / std::abs(b)) : infinity;
  if (a == 0) return by_inertia;
  const double c = b / a * (limit / a) * (limit / a);
  return std::isfinite(c) ? limit / a * first_unit(c) : by_inertia;
}

// A point that moves along the line rest + u inertia, u = s^2, leaves the ball of radius `limit` but once.
double speed_by_reaction(const Eigen::Vector3d& rest, const Eigen::Vector3d& inertia, double limit) {
  const double from_centre = rest.stableNorm(), speed = inertia.stableNorm();
  if (std::isnan(from_centre) || std::isnan(speed)) return nan;
  if (from_centre > limit) return 0;
  if (speed == 0) return infinity;
  // Distance t to the sphere, in radii: t^2 + 2 along t - depth = 0. The form of the root that adds what has one sign.
  const double height = from_centre / limit, along = (rest / limit).dot(inertia / speed), depth = (1 - height) * (1 + height);
  const double root = std::sqrt(along * along + depth);
  const double distance = along > 0 ? depth / (along + root) : root - along;
  return std::sqrt(distance * (limit / speed));
}

FeasibleSpeed feasible_speed(const MotionForces& motion, const MotionLimits& limits) {
  using Kind = SpeedLimit::Kind;
  FeasibleSpeed out;
  const Eigen::Index samples = std::max(motion.actuator_rate.rows(), motion.joint_rest.rows());
  using Along = std::function<double(Eigen::Index, Eigen::Index, double)>;
  const auto hold = [&](Kind kind, const std::vector<double>& bounds, const Along& s, const Along& at_rest) {
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (!std::isfinite(bounds[i])) continue;
      const auto n = static_cast<Eigen::Index>(i);
      SpeedLimit& l = out.limits.emplace_back(SpeedLimit{kind, static_cast<int>(i), {}});
      double least = infinity;
      for (Eigen::Index k = 0; k < samples; ++k) {
        const double here = s(k, n, bounds[i]);
        l.largest.push_back(here);
        const double share = here == 0 ? at_rest(k, n, bounds[i]) : 0;
        if (here < least || (here == 0 && share > l.at_rest)) least = here, l.sample = static_cast<int>(k), l.at_rest = share;
      }
    }
  };
  const auto& m = motion;
  const Along nothing = [](Eigen::Index, Eigen::Index, double) { return 0.0; };  // what stands has neither speed nor power
  hold(
      Kind::actuator_force, limits.force,
      [&](auto k, auto i, double limit) { return speed_by_force(m.actuator_rest(k, i), m.actuator_inertia(k, i), limit); },
      [&](auto k, auto i, double limit) { return std::abs(m.actuator_rest(k, i)) / limit; });
  hold(
      Kind::actuator_speed, limits.speed, [&](auto k, auto i, double limit) { return limit / std::abs(m.actuator_rate(k, i)); }, nothing);
  hold(
      Kind::actuator_power, limits.power,
      [&](auto k, auto i, double limit) {
        return speed_by_power(m.actuator_rest(k, i), m.actuator_inertia(k, i), m.actuator_rate(k, i), limit);
      },
      nothing);
  for (const auto& [kind, bounds, first] :
       {std::tuple{Kind::joint_force, &limits.joint_force, Eigen::Index{0}}, {Kind::joint_moment, &limits.joint_moment, Eigen::Index{3}}}) {
    const auto part = [first = first](const Eigen::MatrixXd& of, Eigen::Index k, Eigen::Index i) -> Eigen::Vector3d {
      return of.row(k).segment<3>(6 * i + first).transpose();
    };
    hold(
        kind, *bounds,
        [&](auto k, auto i, double limit) { return speed_by_reaction(part(m.joint_rest, k, i), part(m.joint_inertia, k, i), limit); },
        [&](auto k, auto i, double limit) { return part(m.joint_rest, k, i).stableNorm() / limit; });
  }

  out.largest.assign(static_cast<std::size_t>(samples), infinity);
  out.scale = infinity;
  std::size_t numbers = 0;
  for (std::size_t l = 0; l < out.limits.size(); ++l)
    for (std::size_t k = 0; k < out.largest.size(); ++k) {
      const double s = out.limits[l].largest[k];
      double& least = out.largest[k];
      least = std::isnan(s) || std::isnan(least) ? nan : std::min(least, s);
      if (std::isnan(s)) continue;
      ++numbers;
    }
  double at_rest = 0;
  for (std::size_t l = 0; l < out.limits.size(); ++l) {
    const SpeedLimit& one = out.limits[l];
    if (one.sample < 0) continue;
    const double s = one.largest[static_cast<std::size_t>(one.sample)];
    if (s < out.scale || (s == 0 && one.at_rest > at_rest))
      out.scale = s, out.limit = static_cast<int>(l), out.sample = one.sample, at_rest = one.at_rest;
  }
  if (!out.limits.empty() && numbers == 0) out.scale = nan;
  return out;
}

}  // namespace pmreport::mechanics
