#include <core/mechanics/assembly/continuum.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

namespace pmreport::mechanics {

using Eigen::MatrixXd;

namespace {

constexpr double joined = 1e-6;                 // bodies in one place; the root of it where roots are double, found to half the digits only
constexpr double shortest = 1e-4, edge = 2e-3;  // steps along a curve
constexpr int most_continuum_steps = 2000;
constexpr std::size_t most_poses = 200, tried = 3;  // of a family of more dimensions; neighbours that a pose is walked to from

}  // namespace

Root ContinuumSearch::judge(const Site& mode) const {
  const Spot s = held_.spot(mode.word, mode.u);
  if (!s.reached) return Root::simple;
  const double bound = held_.rounding(s);
  if (held_.null_directions(s, bound).cols() == 0) return Root::simple;
  if (held_.moving(s, bound).cols() == 0) return Root::chart;
  const MatrixXd t = held_.tangents(s, bound);
  for (Eigen::Index k = 0; k < t.cols(); ++k)
    if (held_.goes_on(s, t.col(k), bound) || held_.goes_on(s, -t.col(k), bound)) return Root::continuum;
  // Where branches cross, the ways to go lie between the directions that all of them span.
  for (Eigen::Index k = 0; k < t.cols(); ++k)
    for (Eigen::Index j = 0; j < k; ++j)
      for (int turn = 1; turn < 12; ++turn) {
        const SmallVector v = std::cos(turn * pi / 12) * t.col(k) + std::sin(turn * pi / 12) * t.col(j);
        if (held_.goes_on(s, v, bound) || held_.goes_on(s, -v, bound)) return Root::continuum;
      }
  return Root::twofold;
}

std::optional<std::size_t> ContinuumSearch::holding(const Site& mode) {
  if (found_.empty()) return {};
  const Spot s = held_.spot(mode.word, mode.u);
  if (!s.reached) return {};
  for (std::size_t c = 0; c < found_.size(); ++c) {
    if (found_[c].word != mode.word) continue;
    const std::vector<Spot>& spots = spots_[c];
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t k = 0; k < spots.size(); ++k) near.emplace_back(HeldActuators::apart(spots[k].bodies, s.bodies), k);
    const std::size_t n = std::min(tried, near.size());
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(n), near.end());
    for (std::size_t i = 0; i < n; ++i) {
      const Spot& from = spots[near[i].second];
      // On a curve the nearest of its poses is not more than a step away.
      if (found_[c].dimension == 1 && near[i].first > 2 * HeldActuators::longest * std::sqrt(from.gram.trace())) break;
      if (!held_.walk_to(from, s.bodies, bounds_[c], joined_[c])) continue;
      if (found_[c].dimension > 1 && near[0].first > HeldActuators::stride && spots.size() < most_poses) keep(c, s, false);
      return c;
    }
  }
  return {};
}

// From a pose on a curve on, until it comes back to the start, or to an end. True when it came back.
bool ContinuumSearch::follow(const Spot& start, SmallVector direction, double bound, std::vector<Spot>& passed, bool& whole) const {
  Spot now = start;
  double h = 0.5 * HeldActuators::longest, farthest = 0;
  for (int k = 0; k < most_continuum_steps;) {
    const std::vector<double> before = now.bodies;
    const HeldActuators::Step how = held_.advance(now, direction, h, bound);
    if (how != HeldActuators::Step::done) {
      h *= 0.5;
      if (how == HeldActuators::Step::edge && h < edge) return false;
      if (h < shortest) break;
      continue;
    }
    ++k;
    const double step = HeldActuators::apart(now.bodies, before), home = HeldActuators::apart(now.bodies, start.bodies);
    if (farthest > 3 * step && home < 1.5 * step && held_.walk_to(now, start.bodies, bound, std::sqrt(joined))) return true;
    farthest = std::max(farthest, home);
    passed.push_back(now);
    h = std::min(HeldActuators::longest, 1.5 * h);
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
  s.ways = held_.tangents(s, bounds_[continuum]);
  c.residual = std::max(c.residual, s.error.lpNorm<Eigen::Infinity>());
  c.coordinates.insert(in_front ? c.coordinates.begin() : c.coordinates.end(), q);
  c.poses.insert(in_front ? c.poses.begin() : c.poses.end(), std::move(pose));
  spots.insert(in_front ? spots.begin() : spots.end(), std::move(s));
}

void ContinuumSearch::enter(const Site& mode) {
  const std::size_t number = found_.size();
  Spot start = held_.spot(mode.word, mode.u);
  if (Spot settled = start; held_.settle(settled, HeldActuators::stride) == HeldActuators::Step::done) start = std::move(settled);
  const double bound = held_.rounding(start);
  const MatrixXd t = held_.tangents(start, bound);
  if (t.cols() == 0) return;  // measured anew, the mode stands alone
  found_.emplace_back();
  spots_.emplace_back();
  bounds_.push_back(bound);
  joined_.push_back(joined);
  found_.back().word = mode.word;
  SmallVector way = t.col(0);
  // What kind of family it is, is seen a little farther on: branches may cross here.
  for (Eigen::Index k = 0; k < 2 * t.cols(); ++k) {
    SmallVector along = (k % 2 == 0 ? 1 : -1) * t.col(k / 2);
    Spot next = start;
    if (held_.advance(next, along, HeldActuators::stride, bound) != HeldActuators::Step::done) continue;
    way = t.col(k / 2);
    found_.back().dimension = static_cast<int>(held_.tangents(next, bound).cols());
    if (held_.moving(next, bound).cols() > found_.back().dimension) joined_.back() = std::sqrt(joined);
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
    for (std::size_t i = 0; i < spots_[into].size(); ++i) near.emplace_back(HeldActuators::apart(spots_[into][i].bodies, s.bodies), i);
    std::ranges::sort(near);
    for (std::size_t i = 0; i < std::min(2 * tried, near.size()); ++i) {
      const Spot& other = spots_[into][near[i].second];
      if (!held_.walk_to(other, s.bodies, bounds_[into], joined_[into]) && !held_.walk_to(s, other.bodies, bounds_[from], joined_[from]))
        continue;
      a.poses.insert(a.poses.end(), b.poses.begin(), b.poses.end());
      a.coordinates.insert(a.coordinates.end(), b.coordinates.begin(), b.coordinates.end());
      a.residual = std::max(a.residual, b.residual);
      a.reached_by_starts += b.reached_by_starts;
      spots_[into].insert(spots_[into].end(), spots_[from].begin(), spots_[from].end());
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
