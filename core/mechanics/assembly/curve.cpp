#include <core/mechanics/assembly/curve.hpp>

#include <core/linear/least_norm.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/assembly/tolerances.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace pmreport::mechanics {

Walk<Arrival> newton(Halt& halt, std::size_t word, SmallVector u, double reach, int max_steps) {
  constexpr double converged = 1e-14, good = 1e-11;  // a few roundings; what rounding may leave where the pose is sensitive
  constexpr double blown_up = 1e7;                   // a step by the error: rounding, in a slope without full rank
  Arrival out;
  double best = std::numeric_limits<double>::infinity();
  SmallVector step = SmallVector::Zero(u.size());
  int halvings = 0;
  for (int k = 0; k < max_steps; ++k) {
    const Site& here = co_await halt.at(word, u);
    if (!here.reached) {
      if (k == 0 || ++halvings > 8) break;
      step *= 0.5;
      u -= step;
      continue;
    }
    const double miss = here.error.lpNorm<Eigen::Infinity>();
    if (miss < best && miss <= good) out = {true, here};
    if (miss <= converged || (best <= good && miss >= best)) break;
    best = miss;
    step = linear::SmallFactors(here.slope).solve(here.error);
    if (!(step.lpNorm<Eigen::Infinity>() < blown_up * miss)) step = linear::least_norm_solution(here.slope, here.error, truncated_pivot);
    const double longest = step.lpNorm<Eigen::Infinity>();
    if (!(longest < 1e12)) break;
    if (longest > reach) step *= reach / longest;
    u += step;
    halvings = 0;
  }
  co_return out;
}

namespace {

constexpr double longest_step = 0.3, shortest_step = 1e-4, edge_step = 0.005;
constexpr int most_curve_steps = 3000;
constexpr double far = 30;

// Rows of the held actuators, each of unit length so that a row that grows without bound at the edge of reach does no harm, and below them
// a direction: the system that both the tangent and the way back to the curve solve.
class Bordered {
 public:
  Bordered(const Site& s, const Release& release, const SmallVector& direction)
      : off_(direction.size()), factors_(rows_of(s, release, direction)) {}
  SmallVector back() const { return factors_.solve(off_); }
  SmallVector tangent() const {
    SmallVector last = SmallVector::Zero(off_.size());
    last(off_.size() - 1) = 1;
    return factors_.solve(last).normalized();
  }

 private:
  SmallMatrix rows_of(const Site& s, const Release& release, const SmallVector& direction) {
    SmallMatrix rows(direction.size(), direction.size());
    Eigen::Index r = 0;
    for (Eigen::Index i = 0; i < direction.size(); ++i) {
      if (i == release.lead) continue;
      rows.row(r) = s.slope.row(i) - release.share(i) * s.slope.row(release.lead);
      const double scale = 1 / rows.row(r).norm();
      rows.row(r) *= scale;
      off_(r++) = (s.error(i) - release.share(i) * s.error(release.lead)) * scale;
    }
    rows.row(r) = direction.transpose();
    off_(r) = 0;
    return rows;
  }

  SmallVector off_;  // errors of the held actuators in the measure of the rows; 0 along the direction
  linear::SmallFactors factors_;
};

struct Knot {  // a pose on the curve
  SmallVector u, tangent;
  double miss = 0, slope = 0;  // of the leading actuator: target less value, and its derivative by arc length
};

// Where, between two knots a step h apart, the leading actuator may pass its target: once where its error changes its sign, twice where
// the cubic through both errors and slopes dips to the other side.
std::vector<double> passages(const Knot& a, const Knot& b, double h) {
  if (std::abs(a.miss - b.miss) > 3) return {};  // a rotary actuator went past half a turn: no passage
  if (a.miss * b.miss <= 0) return {a.miss / (a.miss - b.miss)};
  const double side = a.miss > 0 ? 1 : -1, p = side * a.miss, q = side * b.miss, dp = side * a.slope * h, dq = side * b.slope * h;
  if (!(dp < 0 && dq > 0)) return {};
  const double c3 = 2 * (p - q) + dp + dq, c2 = 3 * (q - p) - 2 * dp - dq;  // p + dp s + c2 s^2 + c3 s^3
  const double root = std::sqrt(std::max(0.0, c2 * c2 - 3 * c3 * dp));
  const double s = std::clamp(-dp / (c2 + root), 0.0, 1.0);
  const double lowest = p + s * (dp + s * (c2 + s * c3));
  if (lowest > 0.1 * std::min(p, q)) return {};
  return {0.5 * s, 0.5 * (1 + s)};
}

}  // namespace

Walk<SolutionCurveEnd> trace(Halt& halt, SolutionCurve curve, const AssemblyTarget& target, std::function<bool(const Site&)> met) {
  SolutionCurveEnd end;
  const auto wrapped = [&](SmallVector difference) {
    for (Eigen::Index i = 0; i < difference.size(); ++i)
      if (target.angle(i)) difference(i) = std::remainder(difference(i), 2 * std::numbers::pi);
    return difference;
  };
  const auto knot_at = [&](const Site& s, const SmallVector& u, const SmallVector& tangent) {
    return Knot{u, tangent, s.error(curve.release->lead), -s.slope.row(curve.release->lead).dot(tangent)};
  };

  // Onto the curve.
  SmallVector u = curve.start, direction = curve.tangent.normalized();
  Knot now;
  for (int k = 0;; ++k) {
    const Site& s = co_await halt.at(curve.word, u);
    if (!s.reached || k == 12) co_return end;
    const Bordered system(s, *curve.release, direction);
    const SmallVector back = system.back();
    const double distance = back.norm();
    if (!(distance < 0.3)) co_return end;
    if (distance < 1e-6) {
      now = knot_at(s, u, system.tangent());
      break;
    }
    u += back;
  }
  const Knot first = now;

  SmallVector bend = SmallVector::Zero(u.size());
  double h = 0.02;
  bool at_edge = false;
  bool homing = false;  // the start is close ahead
  while (end.steps < most_curve_steps) {
    const SmallVector foreseen = (now.tangent + h * bend).normalized();
    u = now.u + h * (now.tangent + 0.5 * h * bend);
    std::optional<Knot> next;
    double away = 0;  // how far the prediction was off the curve, by the step
    for (int k = 0; k < 4; ++k) {
      const Site& s = co_await halt.at(curve.word, u);
      at_edge = !s.reached;
      if (at_edge) break;
      const Bordered system(s, *curve.release, foreseen);
      const SmallVector back = system.back();
      const double distance = back.norm() / h;
      if (k == 0) away = distance;
      if (!(distance < (k == 0 ? 0.3 : 0.1))) break;
      u += back;
      if (distance > 0.01) continue;
      // The slopes are those of a pose a hundredth of a step away: they still serve.
      next = knot_at(s, u, system.tangent());
      next->miss -= s.slope.row(curve.release->lead).dot(back);
      break;
    }
    if (!next || next->tangent.dot(now.tangent) < 0.85) {
      h *= 0.5;
      if (h < (at_edge ? edge_step : shortest_step)) {
        end = {at_edge ? SolutionCurveEnd::How::out_of_reach : SolutionCurveEnd::How::cut, now.u, now.tangent, bend, end.steps};
        co_return end;
      }
      continue;
    }
    ++end.steps;
    const double length = (next->u - now.u).norm();
    for (const double s : passages(now, *next, length)) {
      const Arrival a = co_await newton(halt, curve.word, now.u + s * (next->u - now.u), 0.1, 12);
      if (a.found && (a.site.u - now.u).norm() < 3 * length && met(a.site)) {
        end.how = SolutionCurveEnd::How::closed;
        co_return end;
      }
    }
    bend = (next->tangent - now.tangent) / length;
    now = *next;
    const SmallVector to_first = wrapped(first.u - now.u);
    const double ahead = to_first.dot(now.tangent);
    if (homing && ahead <= 0 && to_first.norm() < longest_step && now.tangent.dot(first.tangent) > 0.8) {
      end.how = SolutionCurveEnd::How::closed;
      co_return end;
    }
    homing = ahead > 0 && to_first.norm() < 2 * longest_step;
    if (now.u.norm() > far) {
      end.how = SolutionCurveEnd::How::far;
      co_return end;
    }
    h = std::min(longest_step, h * std::clamp(std::sqrt(0.03 / std::max(away, 1e-6)), 0.5, 2.0));
  }
  end.how = SolutionCurveEnd::How::cut;
  co_return end;
}

}  // namespace pmreport::mechanics
