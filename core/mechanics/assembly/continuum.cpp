// The measures. All is in numbers: lengths by the mechanism's size, angles in radians. S is the slope of the actuators l by u, v a unit
// vector that S shortens to its smallest singular value s, e what is left of the actuators' error at the mode.
//
// A root is simple, and no other is near, when Newton's method from it is sure to converge (Kantorovich): its first step is at most e / s,
// and the slope along it changes by c a unit way, so that with
//     c (e / s) / s < 1/2,   c = |dS/dv v|                                                                          (1)
// the mode is one root of full rank. A double root that Newton's method came upon from one side has just 1/2 there, so 1/8 is asked for:
//     s > sqrt(8 c e). Where (1) fails the digits do not tell it from a double root; e is at least the rounding at which
// Newton's method stops. The slopes themselves round too: their rounding r is seen by moving u in its last digits, and s > r is asked for
// as well. What fails is singular beyond rounding, and is looked at more closely.
//
// Along v the error of a double root grows with the square of the way, that of a root of order p with its p-th power; on a continuum it
// stays. So the null direction is followed a finite way, each step brought back to the actuator values by least-norm steps: if after a way
// of 0.1 in five steps there is still a pose with these actuator values, away from the first, it is a continuum. The power of a way of 0.1
// is above the 1e-10 that a mode may be off for every order below ten.
//
// The poses of a family of dimension d have d null directions that move the bodies, or more where the family counts twice, as a double root
// does, or where branches cross. So where there are several, each is gone along a little and the poses brought back to the actuator values:
// the secants span the family's directions, and no others. What moves the coordinates but no body, where angles are singular, does not
// count.
#include <core/mechanics/assembly/continuum.hpp>

#include <core/linear/least_norm.hpp>
#include <core/linear/singular_values.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::mechanics {

using Eigen::MatrixXd;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double stops = 1e-14;     // error at which Newton's method has converged
constexpr double verified = 1e-10;  // largest error of a mode
constexpr double probe = 1e-3;      // half way between the slopes whose change is taken
constexpr double stride = 0.02;     // of the way that a continuum must go, and how many of them
constexpr int strides = 5;
constexpr double truncated = 1e-9;                             // of the largest pivot: a direction that the actuators do not feel
constexpr double unmoved = 1e-6;                               // bodies that go slower than this by the coordinates stand still
constexpr double joined = 1e-6;                                // bodies in one place
constexpr double longest = 0.1, shortest = 1e-4, edge = 2e-3;  // steps along a curve
constexpr int most_steps = 2000;
constexpr std::size_t most_poses = 200, tried = 3;  // of a family of more dimensions; neighbours that a pose is walked to from

double apart(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  const double *p = a.data(), *q = b.data();
  for (std::size_t i = 0, n = a.size(); i < n; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return std::sqrt(sum);
}

}  // namespace

ContinuumSearch::Spot ContinuumSearch::spot(std::size_t word, const SmallVector& u) const {
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

// Below it a singular value of the slope may be zero: (1), and the rounding of the slope.
double ContinuumSearch::rounding(const Spot& s) const {
  const linear::LeftSingular of = linear::left_singular(s.slope.transpose());
  double spread = eps * of.values(0);
  for (int k = 0; k < 4; ++k) {  // neighbours in the last digits, each coordinate up or down
    SmallVector u = s.u;
    for (Eigen::Index i = 0; i < u.size(); ++i) u(i) += ((k >> (i % 2)) % 2 == 0 ? 2 : -2) * eps * std::max(1.0, std::abs(u(i)));
    const Spot near = spot(s.word, u);
    if (near.reached) spread = std::max(spread, (near.slope - s.slope).norm());
  }
  const SmallVector v = of.vectors.col(of.vectors.cols() - 1);
  const Spot before = spot(s.word, s.u - probe * v), after = spot(s.word, s.u + probe * v);
  const double change = before.reached && after.reached ? ((after.slope - before.slope) * v).norm() / (2 * probe)
                        : after.reached                 ? ((after.slope - s.slope) * v).norm() / probe
                        : before.reached                ? ((s.slope - before.slope) * v).norm() / probe
                                                        : of.values(0);
  return std::max(16 * spread, std::sqrt(8 * change * std::max(s.error.norm(), stops)));
}

// Unit vectors, columns, that the actuators do not feel beyond a bound.
MatrixXd ContinuumSearch::null_directions(const Spot& s, double bound) const {
  const linear::LeftSingular of = linear::left_singular(s.slope.transpose());
  const Eigen::Index rank = (of.values.array() > bound).count();
  return of.vectors.rightCols(of.vectors.cols() - rank);
}

// Those of them that move a body.
MatrixXd ContinuumSearch::moving(const Spot& s, double bound) const {
  const MatrixXd null = null_directions(s, bound);
  if (null.cols() == 0) return null;
  const linear::LeftSingular of = linear::left_singular(null.transpose() * s.gram * null);  // squares of how fast the bodies go
  return null * of.vectors.leftCols((of.values.array() > unmoved * unmoved).count());
}

// Those of them in which the family goes on: all secants of it to either side lie in their span.
MatrixXd ContinuumSearch::tangents(const Spot& s, double bound) const {
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

// To actuator values, by steps of least norm, within a reach. Done: the spot has moved there.
ContinuumSearch::Step ContinuumSearch::settle(Spot& s, double reach) const {
  const SmallVector from = s.u;
  Spot best = s;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 24; ++k) {
    const double miss = s.error.lpNorm<Eigen::Infinity>();
    if (miss < least) {
      best = s;
    } else if (least <= verified) {
      break;
    }
    least = std::min(least, miss);
    if (least <= stops) break;
    const SmallVector step = linear::least_norm_solution(s.slope, s.error, truncated);
    if (!((s.u + step - from).norm() <= reach)) return Step::lost;
    s = spot(s.word, s.u + step);
    if (!s.reached) return Step::edge;
  }
  s = best;
  return least <= verified ? Step::done : Step::lost;
}

// One step of length h along the family; the direction turns with it.
ContinuumSearch::Step ContinuumSearch::advance(Spot& s, SmallVector& direction, double h, double bound) const {
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
bool ContinuumSearch::goes_on(const Spot& s, const SmallVector& direction, double bound) const {
  Spot now = s;
  SmallVector along = direction;
  for (int k = 0; k < strides; ++k)
    if (const Step how = advance(now, along, stride, bound); how != Step::done) return how == Step::edge && k >= 2;
  return true;
}

Root ContinuumSearch::judge(const Site& mode) const {
  const Spot s = spot(mode.word, mode.u);
  if (!s.reached) return Root::simple;
  const double bound = rounding(s);
  if (null_directions(s, bound).cols() == 0) return Root::simple;
  if (moving(s, bound).cols() == 0) return Root::chart;
  const MatrixXd t = tangents(s, bound);
  for (Eigen::Index k = 0; k < t.cols(); ++k)
    if (goes_on(s, t.col(k), bound) || goes_on(s, -t.col(k), bound)) return Root::continuum;
  // Where branches cross, the ways to go lie between the directions that all of them span.
  for (Eigen::Index k = 0; k < t.cols(); ++k)
    for (Eigen::Index j = 0; j < k; ++j)
      for (int turn = 1; turn < 12; ++turn) {
        const SmallVector v = std::cos(turn * pi / 12) * t.col(k) + std::sin(turn * pi / 12) * t.col(j);
        if (goes_on(s, v, bound) || goes_on(s, -v, bound)) return Root::continuum;
      }
  return Root::twofold;
}

// Along the family to where the bodies are in a given place, by the way that nears them most. False where that does not lead there. The
// tangents are taken anew only where the way has become long: each step is brought back to the family.
bool ContinuumSearch::walk_to(Spot s, const std::vector<double>& bodies, double bound, double tolerance) const {
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
    SmallVector step = t * linear::least_norm_solution(MatrixXd(t.transpose() * s.gram * t), t.transpose() * pull, truncated);
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

std::optional<std::size_t> ContinuumSearch::holding(const Site& mode) {
  if (found_.empty()) return {};
  const Spot s = spot(mode.word, mode.u);
  if (!s.reached) return {};
  for (std::size_t c = 0; c < found_.size(); ++c) {
    if (found_[c].word != mode.word) continue;
    const std::vector<Spot>& spots = spots_[c];
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t k = 0; k < spots.size(); ++k) near.emplace_back(apart(spots[k].bodies, s.bodies), k);
    const std::size_t n = std::min(tried, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(n), near.end());
    for (std::size_t i = 0; i < n; ++i) {
      const Spot& from = spots[near[i].second];
      // On a curve the nearest of its poses is not more than a step away.
      if (found_[c].dimension == 1 && near[i].first > 2 * longest * std::sqrt(from.gram.trace())) break;
      if (!walk_to(from, s.bodies, bounds_[c], joined_[c])) continue;
      if (found_[c].dimension > 1 && near[0].first > stride && spots.size() < most_poses) keep(c, s, false);
      return c;
    }
  }
  return {};
}

// From a pose on a curve on, until it comes back to the start, or to an end. True when it came back.
bool ContinuumSearch::follow(const Spot& start, SmallVector direction, double bound, std::vector<Spot>& passed, bool& whole) const {
  Spot now = start;
  double h = 0.5 * longest, farthest = 0;
  for (int k = 0; k < most_steps;) {
    const std::vector<double> before = now.bodies;
    const Step how = advance(now, direction, h, bound);
    if (how != Step::done) {
      h *= 0.5;
      if (how == Step::edge && h < edge) return false;
      if (h < shortest) break;
      continue;
    }
    ++k;
    const double step = apart(now.bodies, before), home = apart(now.bodies, start.bodies);
    if (farthest > 3 * step && home < 1.5 * step && walk_to(now, start.bodies, bound, std::sqrt(joined))) return true;
    farthest = std::max(farthest, home);
    passed.push_back(now);
    h = std::min(longest, 1.5 * h);
  }
  whole = false;
  return false;
}

void ContinuumSearch::keep(std::size_t continuum, Spot s, bool in_front) {
  ModeContinuum& c = found_[continuum];
  std::vector<Spot>& spots = spots_[continuum];
  const SmallVector q = target_.coordinates(s.u);
  Pose pose = target_.machine(s.word).pose({q.data(), static_cast<std::size_t>(q.size())});
  if (pose.status != PM_OK) return;
  s.ways = tangents(s, bounds_[continuum]);
  c.residual = std::max(c.residual, s.error.lpNorm<Eigen::Infinity>());
  c.coordinates.insert(in_front ? c.coordinates.begin() : c.coordinates.end(), q);
  c.poses.insert(in_front ? c.poses.begin() : c.poses.end(), std::move(pose));
  spots.insert(in_front ? spots.begin() : spots.end(), std::move(s));
}

void ContinuumSearch::enter(const Site& mode) {
  const std::size_t number = found_.size();
  Spot start = spot(mode.word, mode.u);
  settle(start, stride);
  const double bound = rounding(start);
  found_.emplace_back();
  spots_.emplace_back();
  bounds_.push_back(bound);
  joined_.push_back(joined);
  found_.back().word = mode.word;
  const MatrixXd t = tangents(start, bound);
  SmallVector way = t.col(0);
  // What kind of family it is, is seen a little farther on: branches may cross here.
  for (Eigen::Index k = 0; k < 2 * t.cols(); ++k) {
    SmallVector along = (k % 2 == 0 ? 1 : -1) * t.col(k / 2);
    Spot next = start;
    if (advance(next, along, stride, bound) != Step::done) continue;
    way = t.col(k / 2);
    found_.back().dimension = static_cast<int>(tangents(next, bound).cols());
    if (moving(next, bound).cols() > found_.back().dimension) joined_.back() = std::sqrt(joined);
    break;
  }
  keep(number, start, false);
  if (found_.back().dimension > 1) return;
  std::vector<Spot> passed;
  found_.back().closed = follow(start, way, bound, passed, found_.back().whole);
  for (const Spot& s : passed) keep(number, s, false);
  if (found_.back().closed) return;
  passed.clear();
  follow(start, -way, bound, passed, found_.back().whole);
  for (const Spot& s : passed) keep(number, s, true);
}

int ContinuumSearch::least_starts() const {
  int least = std::numeric_limits<int>::max();
  for (const ModeContinuum& c : found_)
    if (c.dimension == 1) least = std::min(least, c.reached_by_starts);
  return least;
}

// Whether a walk leads from a pose of one family to a pose of another, or back; then they are one.
bool ContinuumSearch::join(std::size_t into, std::size_t from) {
  ModeContinuum &a = found_[into], &b = found_[from];
  if (a.word != b.word || a.dimension != b.dimension) return false;
  for (std::size_t k = 0; k < std::min(tried, spots_[from].size()); ++k) {
    const Spot& s = spots_[from][k];
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < spots_[into].size(); ++i) near.emplace_back(apart(spots_[into][i].bodies, s.bodies), i);
    std::ranges::sort(near);
    for (std::size_t i = 0; i < std::min(2 * tried, near.size()); ++i) {
      const Spot& other = spots_[into][near[i].second];
      if (!walk_to(other, s.bodies, bounds_[into], joined_[into]) && !walk_to(s, other.bodies, bounds_[from], joined_[from])) continue;
      a.poses.insert(a.poses.end(), b.poses.begin(), b.poses.end());
      a.coordinates.insert(a.coordinates.end(), b.coordinates.begin(), b.coordinates.end());
      a.residual = std::max(a.residual, b.residual);
      a.reached_by_starts += b.reached_by_starts;
      return true;
    }
  }
  return false;
}

std::vector<ModeContinuum> ContinuumSearch::take() {
  for (std::size_t from = found_.size(); from-- > 1;) {
    if (found_[from].dimension == 1) continue;
    for (std::size_t into = 0; into < from; ++into)
      if (join(into, from)) {
        const auto at = static_cast<std::ptrdiff_t>(from);
        found_.erase(found_.begin() + at);
        spots_.erase(spots_.begin() + at);
        bounds_.erase(bounds_.begin() + at);
        joined_.erase(joined_.begin() + at);
        break;
      }
  }
  return std::move(found_);
}

}  // namespace pmreport::mechanics
