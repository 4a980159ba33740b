#include <core/mechanics/assembly/held_actuators.hpp>

#include <core/linear/least_norm.hpp>
#include <core/linear/singular_values.hpp>
#include <core/mechanics/assembly/tolerances.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

using Eigen::MatrixXd;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double stops = 1e-14;  // error at which Newton's method has converged
constexpr int strides = 5;
constexpr double unmoved = 1e-6;  // bodies that go slower than this by the coordinates stand still

}  // namespace

double HeldActuators::apart(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  const double *p = a.data(), *q = b.data();
  for (std::size_t i = 0, n = a.size(); i < n; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return std::sqrt(sum);
}

HeldActuators::Spot HeldActuators::spot(std::size_t word, const SmallVector& u) const {
  const Machine& m = target_.machine(word);
  const auto n = target_.dof();
  const std::size_t components = 1 + static_cast<std::size_t>(n), bodies_end = m.layout().joint(0);
  const SmallVector q = target_.coordinates(u);
  std::vector<double> placement(m.layout().size() * components);
  Spot s;
  s.word = word;
  s.u = u;
  if (m.place(PM_PARTIALS, 1, q.data(), placement.data()) != PM_OK) return s;
  const auto scalar = [&](std::size_t i) { return placement.data() + i * components; };
  SmallVector values(n);
  s.slope.resize(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double* at = scalar(m.layout().actuator(static_cast<int>(i)));
    values(i) = at[0];
    for (Eigen::Index j = 0; j < n; ++j) s.slope(i, j) = at[1 + j] * target_.coordinate_scale(j) / target_.actuator_scale(i);
  }
  s.error = target_.error(values);
  // By plain loops: these are most of the work.
  const std::size_t rows = bodies_end - 1, dof = static_cast<std::size_t>(n);
  std::vector<double> scale(rows, 1);
  for (std::size_t b = 1; b < m.topology().bodies.size(); ++b)
    for (std::size_t k = 0; k < 3; ++k) scale[m.layout().body(static_cast<int>(b)) - 1 + k] = 1 / target_.size();
  std::array<double, 6> by{};
  for (std::size_t j = 0; j < dof; ++j) by[j] = target_.coordinate_scale(static_cast<Eigen::Index>(j));
  std::array<double, 36> gram{};
  s.bodies.resize(rows);
  s.motion.resize(rows * dof);
  bool finite = true;
  for (std::size_t i = 0; i < rows; ++i) {
    const double* at = scalar(i + 1);
    double* row = s.motion.data() + i * dof;
    s.bodies[i] = at[0] * scale[i];
    for (std::size_t j = 0; j < dof; ++j) {
      row[j] = at[1 + j] * by[j] * scale[i];
      for (std::size_t k = 0; k <= j; ++k) gram[6 * j + k] += row[j] * row[k];
    }
    finite = finite && std::isfinite(s.bodies[i]);
  }
  s.gram.resize(n, n);
  for (std::size_t j = 0; j < dof; ++j)
    for (std::size_t k = 0; k <= j; ++k)
      s.gram(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) =
          s.gram(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) = gram[6 * j + k];
  s.reached = finite && s.error.allFinite() && s.slope.allFinite() && s.gram.allFinite();
  return s;
}

double HeldActuators::rounding(const Spot& s) const {
  const linear::LeftSingular of = linear::left_singular(s.slope.transpose());
  double spread = eps * of.values(0);
  for (int k = 0; k < 4; ++k) {  // neighbours in the last digits, each coordinate up or down
    SmallVector u = s.u;
    for (Eigen::Index i = 0; i < u.size(); ++i) u(i) += ((k >> (i % 2)) % 2 == 0 ? 2 : -2) * eps * std::max(1.0, std::abs(u(i)));
    const Spot near = spot(s.word, u);
    if (near.reached) spread = std::max(spread, (near.slope - s.slope).norm());
  }
  const SmallVector v = of.vectors.col(of.vectors.cols() - 1);
  const Spot before = spot(s.word, s.u - slope_probe * v), after = spot(s.word, s.u + slope_probe * v);
  const double change = before.reached && after.reached ? ((after.slope - before.slope) * v).norm() / (2 * slope_probe)
                        : after.reached                 ? ((after.slope - s.slope) * v).norm() / slope_probe
                        : before.reached                ? ((s.slope - before.slope) * v).norm() / slope_probe
                                                        : of.values(0);
  return std::max(16 * spread, std::sqrt(8 * change * std::max(s.error.norm(), stops)));
}

// Unit vectors, columns, that the actuators do not feel beyond a bound.
MatrixXd HeldActuators::null_directions(const Spot& s, double bound) const {
  const linear::LeftSingular of = linear::left_singular(s.slope.transpose());
  const Eigen::Index rank = (of.values.array() > bound).count();
  return of.vectors.rightCols(of.vectors.cols() - rank);
}

// Those of them that move a body.
MatrixXd HeldActuators::moving(const Spot& s, double bound) const {
  const MatrixXd null = null_directions(s, bound);
  if (null.cols() == 0) return null;
  const linear::LeftSingular of = linear::left_singular(null.transpose() * s.gram * null);  // squares of how fast the bodies go
  return null * of.vectors.leftCols((of.values.array() > unmoved * unmoved).count());
}

// Those of them in which the family goes on: all secants of it to either side lie in their span.
MatrixXd HeldActuators::tangents(const Spot& s, double bound) const {
  const MatrixXd null = moving(s, bound);
  if (null.cols() < 2) return null;
  MatrixXd secants = MatrixXd::Zero(null.rows(), null.cols());
  for (Eigen::Index k = 0; k < null.cols(); ++k) {
    Spot ahead = spot(s.word, s.u + stride * null.col(k)), behind = spot(s.word, s.u - stride * null.col(k));
    const bool forth = ahead.reached && settle(ahead, stride) == Step::done, back = behind.reached && settle(behind, stride) == Step::done;
    if (forth || back) secants.col(k) = ((forth ? ahead.u : s.u) - (back ? behind.u : s.u)) / (forth && back ? 2 * stride : stride);
  }
  const linear::LeftSingular of = linear::left_singular(secants);
  return of.vectors.leftCols((of.values.array() > 0.5).count());
}

HeldActuators::Step HeldActuators::settle(Spot& s, double reach) const {
  const SmallVector from = s.u;
  Spot best = s;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 24; ++k) {
    const double miss = s.error.lpNorm<Eigen::Infinity>();
    if (miss < least) {
      best = s;
    } else if (least <= mode_error) {
      break;
    }
    least = std::min(least, miss);
    if (least <= stops) break;
    const SmallVector step = linear::least_norm_solution(s.slope, s.error, truncated_pivot);
    if (!((s.u + step - from).norm() <= reach)) return Step::lost;
    s = spot(s.word, s.u + step);
    if (!s.reached) return Step::edge;
  }
  s = best;
  return least <= mode_error ? Step::done : Step::lost;
}

HeldActuators::Step HeldActuators::advance(Spot& s, SmallVector& direction, double h, double bound) const {
  Spot next = spot(s.word, s.u + h * direction);
  if (!next.reached) return Step::edge;
  if (const Step how = settle(next, 0.5 * h); how != Step::done) return how;
  if (!((next.u - s.u).dot(direction) >= 0.5 * h)) return Step::lost;
  if (!(apart(next.bodies, s.bodies) >= 0.25 * h * std::sqrt(direction.dot(s.gram * direction)))) return Step::lost;
  const MatrixXd t = tangents(next, bound);
  const SmallVector turned = t * (t.transpose() * direction);
  if (!(turned.norm() >= 0.85)) return Step::lost;
  s = std::move(next);
  direction = turned.normalized();
  return Step::done;
}

// Whether the solutions go on along a null direction. Two strides to an edge of reach are enough: a root of order six would be off by more.
bool HeldActuators::goes_on(const Spot& s, const SmallVector& direction, double bound) const {
  Spot now = s;
  SmallVector along = direction;
  for (int k = 0; k < strides; ++k)
    if (const Step how = advance(now, along, stride, bound); how != Step::done) return how == Step::edge && k >= 2;
  return true;
}

// Along the family to where the bodies are in a given place, by the way that nears them most. False where that does not lead there. The
// tangents are taken anew only where the way has become long: each step is brought back to the family.
bool HeldActuators::walk_to(Spot s, const std::vector<double>& bodies, double bound, double tolerance) const {
  double away = apart(bodies, s.bodies), gone = 0;
  MatrixXd t = s.ways.size() > 0 ? s.ways : tangents(s, bound);
  for (int k = 0; k < 60 && away > tolerance; ++k) {
    if (gone > 2 * longest) t = tangents(s, bound), gone = 0;
    if (t.cols() == 0) return false;
    // Along the tangents, least |D t c - (bodies less those here)|.
    SmallVector pull = SmallVector::Zero(s.u.size());
    const std::size_t dof = static_cast<std::size_t>(s.u.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t j = 0; j < dof; ++j) pull.data()[j] += s.motion.data()[i * dof + j] * (bodies.data()[i] - s.bodies.data()[i]);
    SmallVector step = t * linear::least_norm_solution(MatrixXd(t.transpose() * s.gram * t), t.transpose() * pull, truncated_pivot);
    if (step.norm() > longest) step *= longest / step.norm();
    bool nearer = false;
    for (int halved = 0; halved < 4 && !nearer; ++halved, step *= 0.5) {
      Spot next = spot(s.word, s.u + step);
      if (!next.reached || settle(next, 0.5 * step.norm() + tolerance) != Step::done) continue;
      const double now = apart(bodies, next.bodies);
      nearer = now < 0.95 * away;
      if (nearer) s = std::move(next), away = now, gone += step.norm();
    }
    if (!nearer) return false;
  }
  return away <= tolerance;
}

}  // namespace pmreport::mechanics
