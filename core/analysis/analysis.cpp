#include <core/analysis/sample_work.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace pmreport::analysis {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t index_of(Measure m) { return static_cast<std::size_t>(m); }

}  // namespace

Analysis::Analysis(const scenario::Scenario& scenario, const mechanics::Machine& machine, const Progress& progress)
    : scenario_(scenario), machine_(machine), length_(characteristic_length(machine)) {
  const Eigen::VectorXd home = machine.home(), still = Eigen::VectorXd::Zero(machine.dof());
  mechanics::State s;
  evaluate(machine, home.data(), still.data(), still.data(), s);
  mobility_ = mechanics::mobility(machine, s);
  run(progress);
  dynamics_ = asks_for_dynamics();
  if (dynamics_) run_dynamics(progress);
  find_breaches();
  find_crossings();
}

void Analysis::run(const Progress& progress) {
  const std::size_t n = time().size();
  for (ColumnList* list : {displacement_columns, velocity_columns, acceleration_columns, statics_columns})
    for (const Column& c : list(machine_.topology())) columns_[c.name].assign(n, nan);
  conditions_.assign(n, Condition::good);
  Row nothing;
  nothing.fill(nan);
  measures_.assign(n, nothing);

  const mechanics::Closure closure(machine_);
  const bool statics = scenario_.needs().statics;
  tbb::enumerable_thread_specific<SampleWork> workers([&] { return SampleWork(scenario_, machine_, closure, length_, statics); });
  std::mutex sentences;
  // Blocks, so that a request to stop is heard in time; within a block every sample stands alone and the order does not matter.
  constexpr std::size_t block = 4096;
  for (std::size_t begin = 0; begin < n; begin += block) {
    progress.stop_if_asked();
    tbb::parallel_for(begin, std::min(n, begin + block), [&](std::size_t k) {
      SampleWork& worker = workers.local();
      const int sample = static_cast<int>(k), neighbour = sample > 0 ? sample - 1 : std::min(1, samples() - 1);
      conditions_[k] = worker.run(sample, neighbour, measures_[k], [&](const std::string& name, double value) {
        const auto found = columns_.find(name);
        if (found != columns_.end()) found->second[k] = std::isfinite(value) ? value + 0.0 : nan;  // no negative zero
      });
      if (conditions_[k] == Condition::unreachable || conditions_[k] == Condition::failed) {
        const std::scoped_lock lock(sentences);
        why_[sample] = worker.why();
      }
    });
  }
  for (std::size_t k = 0; k < n; ++k)
    if (conditions_[k] == Condition::failed)
      throw mechanics::MechanismError(PM_FAILED, "sample " + std::to_string(k + 1) + ": " + why_[static_cast<int>(k)]);
}

void Analysis::find_breaches() {
  const Topology& t = machine_.topology();
  const auto look = [&](const std::string& column, const std::string& subject, const std::string& unit, const Range& range, bool stroke) {
    for (const bool above : {false, true}) {
      LimitBreach b{subject, unit, {}, 0, 0, above ? range.max : range.min, above, stroke};
      double worst = 0;
      const std::vector<double>& x = columns_.at(column);
      // A limit that is met exactly is kept: rounding may not break it.
      const double slack = 1e-12 * std::max({1.0, std::abs(range.min), std::abs(range.max)});
      for (int k = 0; k < samples(); ++k) {
        const double value = x[static_cast<std::size_t>(k)], excess = above ? value - range.max : range.min - value;
        if (!(excess > slack)) continue;
        b.samples.push_back(k);
        if (excess > worst) worst = excess, b.worst = k, b.value = value;
      }
      if (!b.samples.empty()) breaches_.push_back(b);
    }
  };
  for (const Actuator& a : t.actuators) look(a.name, a.name + " (" + a.title + ")", a.unit, a.stroke, true);
  for (const Joint& j : t.joints) {
    if (j.kind == JointKind::prismatic) continue;
    for (std::size_t i = 0; i < j.limits.size(); ++i) look(joint_column(j, i), "joint " + j.name, "rad", j.limits[i], false);
  }
}

std::vector<Column> Analysis::columns_of(ColumnList* list) const {
  std::vector<Column> out = list(machine_.topology());
  std::erase_if(out, [&](const Column& c) { return !has(c.name); });
  return out;
}

double Analysis::largest(const std::vector<std::string>& columns) const {
  double out = 0;
  for (const std::string& name : columns)
    for (const double x : column(name))
      if (std::isfinite(x)) out = std::max(out, std::abs(x));
  return out;
}

int Analysis::count(Condition c) const { return static_cast<int>(std::count(conditions_.begin(), conditions_.end(), c)); }

const std::string& Analysis::why(int sample) const {
  static const std::string none;
  const auto found = why_.find(sample);
  return found != why_.end() ? found->second : none;
}

Worst Analysis::worst(Measure m) const {
  Worst w;
  for (int k = 0; k < samples(); ++k) {
    const double x = measures_[static_cast<std::size_t>(k)][index_of(m)];
    if (std::isnan(x)) continue;
    ++w.compared;
    if (w.sample < 0 || x > w.value) w.value = x, w.sample = k;
  }
  return w;
}

namespace {
template <class Predicate>
std::vector<Interval> runs(int n, Predicate&& in) {
  std::vector<Interval> out;
  for (int k = 0; k < n; ++k) {
    if (!in(k)) continue;
    if (!out.empty() && out.back().last == k - 1)
      out.back().last = k;
    else
      out.push_back({k, k});
  }
  return out;
}
}  // namespace

std::vector<Interval> Analysis::broken() const {
  std::vector<bool> bad(time().size());
  for (const LimitBreach& b : breaches_)
    for (const int k : b.samples) bad[static_cast<std::size_t>(k)] = true;
  return runs(samples(), [&](int k) { return bad[static_cast<std::size_t>(k)]; });
}

std::vector<Interval> Analysis::unreachable() const {
  return runs(samples(), [&](int k) { return condition(k) == Condition::unreachable; });
}

mechanics::Pose Analysis::pose(int sample) const {
  const Eigen::VectorXd q = scenario_.motion.value.row(sample);
  return machine_.pose({q.data(), static_cast<std::size_t>(q.size())});
}

int Analysis::sample_at(double t) const {
  const auto after = std::lower_bound(time().begin(), time().end(), t);
  if (after == time().end()) return samples() - 1;
  const int k = static_cast<int>(after - time().begin());
  return k > 0 && t - time()[static_cast<std::size_t>(k - 1)] < *after - t ? k - 1 : k;
}

}  // namespace pmreport::analysis
