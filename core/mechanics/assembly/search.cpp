#include <core/mechanics/assembly/search.hpp>

#include <core/linear/square.hpp>
#include <core/mechanics/assembly/tolerances.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ranges>

namespace pmreport::mechanics {

namespace {

constexpr std::size_t walkers = 16;  // as many as are placed together
constexpr int often = 4;             // starts that reach a mode, so that the rarest of all is likely to have been seen

}  // namespace

AssemblySearch::AssemblySearch(std::span<const std::unique_ptr<Machine>> machines, const Eigen::VectorXd& actuators,
                               const AssemblyOptions& options, AssemblyModes& out)
    : options_(options),
      out_(out),
      machines_(machines),
      target_(machines, actuators),
      placer_(target_),
      continua_(target_),
      home_(target_.numbers(machines.front()->home())),
      random_(options.seed) {
  releases();
  for (const auto& a : machines_) {
    neighbours_.emplace_back();
    for (std::size_t b = 0; b < machines_.size(); ++b) {
      int differences = 0;
      for (std::size_t i = 0; i < a->values().size(); ++i) differences += a->values()[i] != machines_[b]->values()[i];
      if (differences == 1) neighbours_.back().push_back(b);
    }
  }
}

// Each actuator alone, and as many ways in which all move together: curves of other families join what one family leaves apart.
void AssemblySearch::releases() {
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t k = 0; k < 2 * static_cast<std::size_t>(target_.dof()); ++k) {
    Eigen::VectorXd share = Eigen::VectorXd::Zero(target_.dof());
    if (k < static_cast<std::size_t>(target_.dof()))
      share(static_cast<Eigen::Index>(k)) = 1;
    else
      for (double& x : share) x = unit(random_);
    Eigen::Index lead = 0;
    share.cwiseAbs().maxCoeff(&lead);
    releases_.push_back({k, lead, share / share(lead)});
  }
}

bool AssemblySearch::same_bodies(const Machine& m, const Pose& a, const Pose& b, double tolerance) {
  const std::size_t end = m.layout().joint(0);
  for (std::size_t i = 1; i < end; ++i)
    if (!(std::abs(a.numbers[i] - b.numbers[i]) <= tolerance)) return false;
  return true;
}

std::size_t AssemblySearch::known_mode(const Machine& m, const Pose& pose, double near) const {
  for (std::size_t k = 0; k < out_.modes.size(); ++k)
    if (same_bodies(m, pose, out_.modes[k].pose, near * target_.size())) return k;
  return no_mode;
}

// Whether no more modes are kept; that ends the search.
bool AssemblySearch::full() {
  if (out_.modes.size() + continua_.size() < options_.most_modes) return false;
  out_.ended = AssemblyModes::Ended::most_modes;
  return true;
}

AssemblySearch::Entry AssemblySearch::enter_continuum(const Site& site, int start) {
  if (full()) return {};
  continua_.enter(site);
  quiet_ = 0;
  if (start > 0) out_.last_new = start, continua_.count_start(continua_.size() - 1);
  return {no_mode, true, true};
}

// The mode at a site, entered among the modes if it is new: bodies and platform stand where no other mode has them.
AssemblySearch::Entry AssemblySearch::enter(const Site& site, int start) {
  const Machine& m = *machines_[site.word];
  SmallVector q = target_.coordinates(site.u);
  for (Eigen::Index i = 0; i < q.size(); ++i)
    if (target_.angle(i)) q(i) = std::remainder(q(i), 2 * pi);
  const Pose pose = m.pose({q.data(), static_cast<std::size_t>(q.size())});
  if (pose.status != PM_OK) return {};
  const double residual =
      target_.error(Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + m.layout().actuator(0), m.dof())).lpNorm<Eigen::Infinity>();
  if (!(residual <= mode_error)) return {};
  std::size_t mode = known_mode(m, pose, same_placement);
  if (mode != no_mode) return {mode, true, false};
  if (const std::optional<std::size_t> known = continua_.holding(site)) {
    if (start > 0) continua_.count_start(*known);
    return {no_mode, true, false};
  }
  const Root root = continua_.judge(site);
  if (root == Root::continuum) return enter_continuum(site, start);
  // A double root is found to half the digits only.
  if (root == Root::twofold) mode = known_mode(m, pose, std::sqrt(same_placement));
  if (mode != no_mode) return {mode, true, false};
  if (full()) return {};
  AssemblyMode entered;
  entered.word = site.word;
  entered.coordinates = q;
  entered.pose = pose;
  entered.twofold = root == Root::twofold;
  entered.chart = root == Root::chart;
  mode = out_.modes.size();
  out_.modes.push_back(entered);
  released_.emplace_back(releases_.size(), false);
  quiet_ = 0;
  if (start > 0) out_.last_new = start;
  if (root == Root::chart) return {mode, true, true};  // its curves turn by any angle here without moving a body
  const linear::SmallFactors slope(site.slope);
  for (const Release& r : releases_) {
    const SmallVector tangent = slope.solve(r.share);
    if (tangent.allFinite()) lines_.push_back({{site.word, &r, site.u, tangent}, mode, false});
  }
  return {mode, true, true};
}

bool AssemblySearch::enough() {
  if (out_.ended == AssemblyModes::Ended::most_modes) return true;
  const auto known = static_cast<int>(out_.modes.size() + continua_.size());
  if (quiet_ >= std::max(options_.quiet_arrivals, 12 * known) &&
      std::ranges::all_of(out_.modes, [](const AssemblyMode& m) { return m.reached_by_starts >= often; }) &&
      continua_.least_starts() >= often) {
    out_.ended = AssemblyModes::Ended::quiet;
    return true;
  }
  if (out_.starts < options_.most_starts) return false;
  out_.ended = AssemblyModes::Ended::most_starts;
  return true;
}

// Starts over the whole space: angles all around, positions in boxes of all sizes up to `widest`, about home, about modes, and about where
// all positions are zero, which is as far from home as from what mirrors it. Poses that cannot be assembled
// are drawn anew a few times, then pulled towards home. Of the words of the working mode every other start takes the one whose actuators
// are nearest to their targets.
void AssemblySearch::more_candidates() {
  constexpr double widest = 1.5;
  constexpr int draws = 24, pulls = 8;
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<SmallVector> poses(walkers);
  std::vector<bool> settled(walkers, false);
  for (int draw = 0; draw < draws + pulls; ++draw) {
    for (std::size_t k = 0; k < walkers; ++k) {
      if (settled[k]) continue;
      if (draw >= draws) {
        poses[k] = home_ + 0.7 * (poses[k] - home_);
        continue;
      }
      const double box = widest * std::abs(unit(random_));
      const bool at_mode = k % 4 == 2 && !out_.modes.empty();
      poses[k] = at_mode ? target_.numbers(out_.modes[random_() % out_.modes.size()].coordinates) : home_;
      if (k % 4 == 3)
        for (Eigen::Index i = 0; i < home_.size(); ++i) poses[k](i) = target_.angle(i) ? home_(i) : 0;
      for (Eigen::Index i = 0; i < home_.size(); ++i) poses[k](i) += unit(random_) * (target_.angle(i) ? pi : box);
    }
    const std::vector<double> miss = placer_.misses(random_() % machines_.size(), poses);
    for (std::size_t k = 0; k < walkers; ++k) settled[k] = settled[k] || std::isfinite(miss[k]);
    if (std::ranges::all_of(settled, std::identity{})) break;
  }
  std::vector<std::vector<double>> misses;
  for (std::size_t w = 0; w < machines_.size(); ++w) misses.push_back(placer_.misses(w, poses));
  std::vector<std::size_t> possible;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    possible.clear();
    for (std::size_t w = 0; w < misses.size(); ++w)
      if (std::isfinite(misses[w][k])) possible.push_back(w);
    if (possible.empty()) continue;
    std::size_t word = possible[random_() % possible.size()];
    if (k % 2 == 0)
      for (const std::size_t w : possible)
        if (misses[w][k] < misses[word][k]) word = w;
    candidates_.push_back({word, poses[k]});
  }
}

void AssemblySearch::begin_start(std::size_t word, const SmallVector& u) {
  Task task;
  task.halt = std::make_unique<Halt>();
  task.start = newton(*task.halt, word, u, 0.3, 40);
  task.number = ++out_.starts;
  task.start->begin();
  tasks_.push_back(std::move(task));
}

void AssemblySearch::begin_trace(const Line& line) {
  Task task;
  task.halt = std::make_unique<Halt>();
  task.line = line;
  const auto released = line.curve.release->number;
  if (line.mode != no_mode) released_[line.mode][released] = true;
  ++out_.curves;
  task.trace = trace(*task.halt, line.curve, target_, [this, mode = line.mode, released](const Site& site) {
    const std::size_t passed = enter(site, 0).mode;
    if (passed == no_mode) return false;
    // A curve that comes from an edge of reach need not go on where another has been.
    const bool end = mode == no_mode ? released_[passed][released] : passed == mode;
    released_[passed][released] = true;
    return end;
  });
  task.trace->begin();
  tasks_.push_back(std::move(task));
}

// Curves before starts: they are what finds most. False when there is nothing more to do.
bool AssemblySearch::begin_next() {
  while (!lines_.empty()) {
    const Line line = lines_.front();
    lines_.pop_front();
    if (line.mode != no_mode && !line.back && released_[line.mode][line.curve.release->number]) continue;
    begin_trace(line);
    return true;
  }
  if (enough()) return false;
  for (int tries = 0; candidates_.empty() && tries < 64; ++tries) more_candidates();
  if (candidates_.empty()) {
    out_.ended = AssemblyModes::Ended::no_start;
    return false;
  }
  begin_start(candidates_.front().first, candidates_.front().second);
  candidates_.pop_front();
  return true;
}

// A curve that goes out of reach meets there a curve of a word with one other choice, for both are halves of one smooth curve of the
// mechanism. Where it is a held actuator that comes to the end of its reach, the poses go on beyond; where it is the released one they turn
// back, with other values of that actuator. Both are tried with each such word: those that do not fit are not on the curve and end at once.
void AssemblySearch::cross_the_edge(const SolutionCurve& curve, const SolutionCurveEnd& end) {
  for (const auto& [release, u] : edges_)
    if (release == curve.release && (u - end.u).norm() < 0.02) return;
  edges_.emplace_back(curve.release, end.u);
  if (!neighbours_[curve.word].empty()) ++out_.edges;
  for (const std::size_t word : neighbours_[curve.word]) {
    lines_.push_back({{word, curve.release, end.u, -end.tangent}, no_mode, false});
    for (const double s : {0.02, 0.06}) {
      const SmallVector u = end.u + s * (end.tangent + 0.5 * s * end.bend), tangent = end.tangent + s * end.bend;
      lines_.push_back({{word, curve.release, u, tangent}, no_mode, false});
    }
  }
}

void AssemblySearch::finish(Task& task) {
  if (task.trace) {
    const SolutionCurveEnd end = task.trace->result();
    out_.curves_cut += end.how == SolutionCurveEnd::How::cut;
    out_.curves_far += end.how == SolutionCurveEnd::How::far;
    if (end.how == SolutionCurveEnd::How::out_of_reach) cross_the_edge(task.line.curve, end);
    if (end.how == SolutionCurveEnd::How::closed || task.line.mode == no_mode || task.line.back) return;
    Line back = task.line;
    back.back = true;
    back.curve.tangent = -back.curve.tangent;
    lines_.push_back(back);
    return;
  }
  const Arrival a = task.start->result();
  if (!a.found) return;
  const Entry entry = enter(a.site, task.number);
  if (!entry.solution) return;
  ++out_.arrivals;
  if (entry.mode != no_mode) ++out_.modes[entry.mode].reached_by_starts;
  if (!entry.fresh) ++quiet_;
}

void AssemblySearch::run(const Eigen::VectorXd& reference) {
  candidates_.push_back({0, target_.numbers(reference)});
  work();
}

void AssemblySearch::go_on(std::size_t word, const Eigen::VectorXd& coordinates) {
  begin_start(word, target_.numbers(coordinates));
  work();
}

void AssemblySearch::work() {
  std::vector<Site*> sites;
  while (true) {
    while (tasks_.size() < walkers && begin_next()) {
    }
    if (tasks_.empty()) break;
    sites.clear();
    for (Task& t : tasks_) sites.push_back(&t.halt->site);
    out_.placements += static_cast<std::int64_t>(sites.size());
    placer_.place(sites);
    for (std::size_t k = 0; k < tasks_.size();) {
      Task& t = tasks_[k];
      t.halt->next.resume();
      if (t.start ? t.start->done() : t.trace->done()) {
        finish(t);
        tasks_.erase(tasks_.begin() + static_cast<std::ptrdiff_t>(k));
      } else {
        ++k;
      }
    }
  }
}

}  // namespace pmreport::mechanics
