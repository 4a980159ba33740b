#include <core/analysis/analysis.hpp>

#include <core/analysis/proved_crossings.hpp>
#include <core/analysis/samples/sample_work.hpp>
#include <core/analysis/transmission/transmission_numbers.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>

namespace pmreport::analysis {

namespace {

// What the checks hold extremes of columns against: brackets should tell.
std::vector<std::pair<ColumnId, double>> bounds_of_checks(const scenario::Scenario& scenario) {
  std::vector<std::pair<ColumnId, double>> out;
  for (const scenario::Check& c : scenario.checks) {
    if (c.reduction != "max" && c.reduction != "min") continue;
    for (const auto& bound : {c.below, c.above}) {
      if (!bound) continue;
      for (const std::string& column : c.columns) {
        out.emplace_back(ColumnId::named(column), *bound);
        if (c.absolute) out.emplace_back(ColumnId::named(column), -*bound);
      }
    }
  }
  return out;
}

}  // namespace

Analysis::Analysis(const scenario::Scenario& scenario, const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
                   const Asked& asked, const Progress& progress)
    : scenario_(scenario),
      trajectory_(trajectory),
      machine_(machine),
      asked_(asked),
      length_(characteristic_length(machine)),
      residuals_(trajectory.time.size()) {
  const Eigen::VectorXd home = machine.home(), still = Eigen::VectorXd::Zero(machine.dof());
  mechanics::State s;
  evaluate(machine, home.data(), still.data(), still.data(), s);
  mobility_ = mechanics::mobility(machine, s);
  run(progress);
  if (asked_.forces) run_dynamics(progress);
  if (asked_.stiffness) run_stiffness(progress);
  breaches_ = find_breaches(machine.topology(), columns_);
  proof_.unexamined = "there is no motion";
  if (!asked_.singularities) return;
  if (scenario.motion && samples() > 0) {
    proof_ = prove_motion(machine, trajectory, scenario.motion->by_actuators() ? scenario.motion->over : mechanics::Enclosure{},
                          {.decide = bounds_of_checks(scenario)});
    progress.stop_if_asked();
  }
  singular_everywhere_ = mechanics::singular_everywhere(machine, length_);
  if (singular_everywhere_) return;  // a surface that is everywhere is met nowhere
  crossings_ = find_crossings(trajectory, machine, wrenches_, length_);
  match_with_proof(crossings_, proof_, trajectory);
  progress.stop_if_asked();
  margins_ = follow_margins(trajectory, machine, length_);
  for (const Crossing& c : margins_.losses) crossings_.push_back(c);
  std::ranges::stable_sort(crossings_, {}, &Crossing::time);
}

void Analysis::run(const Progress& progress) {
  const std::size_t n = time().size();
  for (ColumnList* list : {displacement_columns, velocity_columns, acceleration_columns, statics_columns})
    for (const Column& c : list(machine_.topology())) columns_.add(c, n);
  if (asked_.transmission) {
    transmission_ = std::make_unique<const mechanics::Transmission>(machine_, asked_.transmission_length);
    const std::vector<Column> columns = transmission_columns(machine_.topology());
    const std::vector<std::string> reasons = why_without(*transmission_);
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (reasons[i].empty()) columns_.add(columns[i], n);
  }
  outcomes_.assign(n, Outcome::good);
  wrenches_.assign(n, {});

  const mechanics::Closure closure(machine_);
  tbb::enumerable_thread_specific<SampleWork> workers(
      [&] { return SampleWork(trajectory_, scenario_.load, machine_, closure, length_, asked_, transmission_.get()); });
  std::mutex sentences;
  // Blocks, so that a request to stop is heard in time; within a block every sample stands alone and the order does not matter.
  constexpr std::size_t block = 4096;
  for (std::size_t begin = 0; begin < n; begin += block) {
    progress.stop_if_asked();
    tbb::parallel_for(begin, std::min(n, begin + block), [&](std::size_t k) {
      SampleWork& worker = workers.local();
      const int sample = static_cast<int>(k), neighbour = sample > 0 ? sample - 1 : std::min(1, samples() - 1);
      outcomes_[k] = worker.run(sample, neighbour, residuals_[k], [&](const ColumnId& id, double value) { columns_.put(id, k, value); });
      wrenches_[k] = worker.wrenches();
      if (outcomes_[k] != Outcome::good) {
        const std::scoped_lock lock(sentences);
        why_[sample] = worker.why();
      }
    });
  }
  for (std::size_t k = 0; k < n; ++k)
    if (outcomes_[k] == Outcome::failed)
      throw mechanics::MechanismError(PM_FAILED, "sample " + std::to_string(k + 1) + ": " + why_[static_cast<int>(k)]);
}

std::vector<Column> Analysis::columns_of(ColumnList* list) const {
  std::vector<Column> out = list(machine_.topology());
  std::erase_if(out, [&](const Column& c) { return !has(c); });
  return out;
}

int Analysis::count(Outcome c) const { return static_cast<int>(std::count(outcomes_.begin(), outcomes_.end(), c)); }

const std::string& Analysis::why(int sample) const {
  static const std::string none;
  const auto found = why_.find(sample);
  return found != why_.end() ? found->second : none;
}

std::vector<SampleRun> Analysis::unreachable() const {
  return runs(samples(), [&](int k) { return outcome(k) == Outcome::unreachable; });
}

mechanics::Pose Analysis::pose(int sample) const {
  const Eigen::VectorXd q = trajectory_.value.row(sample);
  return machine_.pose({q.data(), static_cast<std::size_t>(q.size())});
}

int Analysis::sample_at(double t) const {
  const auto after = std::lower_bound(time().begin(), time().end(), t);
  if (after == time().end()) return samples() - 1;
  const int k = static_cast<int>(after - time().begin());
  return k > 0 && t - time()[static_cast<std::size_t>(k - 1)] < *after - t ? k - 1 : k;
}

}  // namespace pmreport::analysis
