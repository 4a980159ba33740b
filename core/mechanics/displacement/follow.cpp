#include <core/mechanics/displacement/follow.hpp>

#include <core/assertion.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>
#include <core/mechanics/model/tangent.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

namespace {

// Of the mechanism's size, or radians. A longer step could pass over a neighbouring branch.
constexpr double longest_step = 0.25;
// How far the solution may lie from the prediction: a share of the step, so that the prediction follows the branch, or a distance within
// which no other branch with the same sign of det G lies.
constexpr double largest_share = 0.25, negligible = 1e-3;
// Of the whole span: how near an obstacle is approached, hence how exactly its time is known.
constexpr double resolution_of_span = 1e-10;
// On a branch that folds back det G_ vanishes as the root of the time that is left, at the resolution to 1e-5; at the edge of reach it
// stays.
constexpr double vanished = 1e-3;

}  // namespace

Follower::Follower(const Machine& machine, const Drive& drive)
    : machine_(machine),
      drive_(drive),
      solver_(machine),
      unit_(machine.dof()),
      length_(characteristic_length(machine)),
      values_(machine.layout().size()),
      partials_(machine.layout().size() * machine.components(PM_PARTIALS)),
      jets_(machine.layout().size() * machine.components(PM_JET)) {
  for (int i = 0; i < machine.dof(); ++i)
    unit_(i) = mechanics::size_of(machine.topology().coordinates[static_cast<std::size_t>(i)].sense(), length_);
  largest_margin_ = margin(machine.home());
}

double Follower::size_of(const SmallVector& dq) const { return (dq.array() / unit_.array()).abs().maxCoeff(); }

// G_ at q; nothing where q cannot be assembled.
std::optional<Matrix6d> Follower::wrenches(const SmallVector& q) {
  if (machine_.place(PM_VALUE, 1, q.data(), values_.data()) != PM_OK) return std::nullopt;
  const Jacobian g = machine_.jacobian(values_.data());
  return g.known() ? std::optional(unit_wrenches(g.matrix, length_)) : std::nullopt;
}

// The side of the singular surface; 0 on it, and where q cannot be assembled.
int Follower::side(const SmallVector& q) {
  const auto g = wrenches(q);
  return g ? linear::sign_of_determinant(*g) : 0;
}

// |det G_|, which vanishes on the surface; NaN where q cannot be assembled.
double Follower::margin(const SmallVector& q) {
  const auto g = wrenches(q);
  return g ? std::abs(linear::determinant(*g)) : std::numeric_limits<double>::quiet_NaN();
}

// (1) and (2). The jet of l along (q, q', 0) has the second derivative J' q', exactly.
Waymark Follower::waymark(double t, const SmallVector& q) {
  const int m = machine_.dof();
  const std::size_t first = machine_.layout().actuator(0), components = machine_.components(PM_PARTIALS);
  SmallVector l(m), rate(m), acceleration(m);
  drive_(t, l.data(), rate.data(), acceleration.data());
  machine_.place(PM_PARTIALS, 1, q.data(), partials_.data());
  SmallMatrix j(m, m);
  for (int i = 0; i < m; ++i)
    for (int k = 0; k < m; ++k) j(i, k) = partials_[(first + static_cast<std::size_t>(i)) * components + 1 + static_cast<std::size_t>(k)];
  const linear::SmallFactors lu(j);
  Waymark out{t, q, lu.solve(rate), SmallVector::Zero(m)};

  std::vector<double> along(static_cast<std::size_t>(3 * m));
  for (int i = 0; i < m; ++i) {
    along[static_cast<std::size_t>(3 * i)] = q(i);
    along[static_cast<std::size_t>(3 * i + 1)] = out.rate(i);
    along[static_cast<std::size_t>(3 * i + 2)] = 0;
  }
  machine_.place(PM_JET, 1, along.data(), jets_.data());
  for (int i = 0; i < m; ++i) acceleration(i) -= jets_[3 * (first + static_cast<std::size_t>(i)) + 2];
  out.acceleration = lu.solve(acceleration);
  return out;
}

bool Follower::step(const Waymark& from, double to, SmallVector& q) {
  const int m = machine_.dof();
  SmallVector l(m), rate(m), acceleration(m);
  drive_(to, l.data(), rate.data(), acceleration.data());
  if (!l.allFinite()) return false;
  const double h = to - from.time;
  const int side_before = side(from.value);
  SmallVector guess = from.value + h * (from.rate + h / 2 * from.acceleration);  // (3)
  if (!guess.allFinite() || size_of(guess - from.value) > longest_step) return false;
  if (side(guess) * side_before <= 0) guess = from.value;
  const ForwardSolution s = solver_.solve(l, guess);
  if (s.outcome != Outcome::good) return false;
  const double moved = size_of(s.coordinates - from.value), corrected = size_of(s.coordinates - guess);
  if (moved > longest_step || corrected > std::max(largest_share * moved, negligible)) return false;
  if (side(s.coordinates) * side_before <= 0) return false;
  largest_margin_ = std::max({largest_margin_, margin(from.value), margin(s.coordinates)});
  q = s.coordinates;
  return true;
}

Follower::Arrival Follower::go(Waymark at, double to, double resolution) {
  double h = to - at.time;
  const double direction = h < 0 ? -1 : 1;
  SmallVector q;
  while (at.time != to) {
    const bool last = std::abs(h) >= std::abs(to - at.time);
    const double next = last ? to : at.time + h;
    if (step(at, next, q)) {
      at = waymark(next, q);
      h *= 2;
      continue;
    }
    h = (next - at.time) / 2;
    if (std::abs(h) < resolution) return stopped(std::move(at), direction, resolution);
  }
  return {std::move(at), Outcome::good, ""};
}

// Why the way ends: where the coordinates are singular they cannot follow; where det G_ has vanished the surface is singular. Elsewhere the
// mechanism may say itself why it goes no further.
Follower::Arrival Follower::stopped(Waymark at, double direction, double resolution) {
  if (const auto fault = chart_fault(machine_, at.value, length_)) return {std::move(at), Outcome::singular, in_words(machine_, *fault)};
  if (!(margin(at.value) > vanished * largest_margin_)) return {std::move(at), Outcome::singular, ""};
  std::string why;
  for (double h = resolution; why.empty() && size_of(h * at.rate) < negligible && h < 1e9 * resolution; h *= 2) {
    const SmallVector beyond = at.value + direction * h * at.rate;
    if (machine_.place(PM_VALUE, 1, beyond.data(), values_.data(), &why) == PM_OK) why.clear();
  }
  return {std::move(at), Outcome::unreachable, why};
}

FollowedMotion follow(const Machine& machine, const Drive& drive, const std::vector<double>& times, const SmallVector& start) {
  PMREPORT_ASSERT(!times.empty() && start.size() == machine.dof(), "a way has a beginning");
  FollowedMotion out;
  const auto rows = static_cast<Eigen::Index>(times.size());
  for (Eigen::MatrixXd* m : {&out.value, &out.rate, &out.acceleration})
    m->setConstant(rows, machine.dof(), std::numeric_limits<double>::quiet_NaN());
  const double resolution = resolution_of_span * (times.back() - times.front());
  Follower follower(machine, drive);
  Follower::Arrival a{follower.waymark(times.front(), start), Outcome::good, ""};
  for (Eigen::Index k = 0; k < rows; ++k) {
    if (k > 0) a = follower.go(std::move(a.at), times[static_cast<std::size_t>(k)], resolution);
    out.ending = a.at.time;
    if (a.outcome != Outcome::good) {
      out.outcome = a.outcome;
      out.why = a.why;
      return out;
    }
    out.value.row(k) = a.at.value;
    out.rate.row(k) = a.at.rate;
    out.acceleration.row(k) = a.at.acceleration;
    ++out.reached;
  }
  return out;
}

SmallVector actuators_at(const Machine& machine, const SmallVector& coordinates) {
  std::vector<double> values(machine.layout().size());
  if (machine.place(PM_VALUE, 1, coordinates.data(), values.data()) != PM_OK)
    return SmallVector::Constant(machine.dof(), std::numeric_limits<double>::quiet_NaN());
  return Eigen::Map<const Eigen::VectorXd>(values.data() + machine.layout().actuator(0), machine.dof());
}

Approach approach(const Machine& machine, const SmallVector& start, const SmallVector& actuators) {
  const SmallVector from = actuators_at(machine, start), way = actuators - from;
  const Drive straight = [&](double share, double* value, double* rate, double* acceleration) {
    for (int i = 0; i < way.size(); ++i) value[i] = from(i) + share * way(i), rate[i] = way(i), acceleration[i] = 0;
    if (share == 1) std::copy_n(actuators.data(), actuators.size(), value);
  };
  Follower follower(machine, straight);
  const Follower::Arrival a = follower.go(follower.waymark(0, start), 1, resolution_of_span);
  return {a.at.value, a.at.time, a.outcome, a.why};
}

}  // namespace pmreport::mechanics
