#include <core/analysis/analysis.hpp>

#include <core/analysis/proved_crossings.hpp>
#include <core/analysis/samples/motion_blocks.hpp>
#include <core/analysis/samples/power_balance.hpp>
#include <core/mechanics/singularity/singularity.hpp>

#include <fmt/format.h>

#include <algorithm>

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
    : scenario_(scenario), trajectory_(trajectory), machine_(machine), asked_(asked), length_(characteristic_length(machine)) {
  const Eigen::VectorXd home = machine.home(), still = Eigen::VectorXd::Zero(machine.dof());
  mechanics::State s;
  evaluate(machine, home.data(), still.data(), still.data(), s);
  mobility_ = mechanics::mobility(machine, s);
  if (asked_.transmission) transmission_ = std::make_unique<const mechanics::Transmission>(machine_, asked_.transmission_length);
  run(progress);
  breaches_ = find_breaches(machine.topology(), answers_.columns);
  proof_.unexamined = "there is no motion";
  if (asked_.singularities) find_singularities(progress);
}

void Analysis::run(const Progress& progress) {
  MotionBlocks blocks(scenario_, trajectory_, machine_, asked_, length_, transmission_.get());
  answers_ = MotionAnswers(blocks.shape(), time().size());
  if (samples() == 0) return;
  const auto take = [&](std::size_t block, std::span<const std::byte> answers) {
    answers_.take(answers, blocks.first(block), blocks.samples(block));
    for (std::size_t k = blocks.first(block); k < blocks.first(block) + blocks.samples(block); ++k)
      if (answers_.outcomes[k] == Outcome::failed)
        throw mechanics::MechanismError(PM_FAILED, fmt::format("sample {}: {}", k + 1, why(static_cast<int>(k))));
  };
  const auto tell = [&](double share) {
    if (share < 1) progress.say(fmt::format("{} samples: {:.0f} %", samples(), 100 * share));
  };
  chunks::run({"motion", blocks.meaning(), blocks.count()}, progress.sharing,
              [&](std::size_t block) { return blocks.compute(block, progress.stop_if_asked).bytes(); }, take,
              {tell, progress.stop_if_asked});
  if (asked_.forces && asked_.power_evidence) balance_power(trajectory_, scenario_.load, machine_, answers_);
}

void Analysis::find_singularities(const Progress& progress) {
  if (scenario_.motion && samples() > 0) {
    proof_ = prove_motion(machine_, trajectory_, scenario_.motion->by_actuators() ? scenario_.motion->over : mechanics::Enclosure{},
                          {.decide = bounds_of_checks(scenario_)});
    progress.stop_if_asked();
  }
  singular_everywhere_ = mechanics::singular_everywhere(machine_, length_);
  if (singular_everywhere_) return;  // a surface that is everywhere is met nowhere
  crossings_ = find_crossings(trajectory_, machine_, answers_.wrenches, length_);
  match_with_proof(crossings_, proof_, trajectory_);
  progress.stop_if_asked();
  margins_ = follow_margins(trajectory_, machine_, length_);
  for (const Crossing& c : margins_.losses) crossings_.push_back(c);
  std::ranges::stable_sort(crossings_, {}, &Crossing::time);
}

std::vector<Column> Analysis::columns_of(ColumnList* list) const {
  std::vector<Column> out = list(machine_.topology());
  std::erase_if(out, [&](const Column& c) { return !has(c); });
  return out;
}

int Analysis::count(Outcome c) const { return static_cast<int>(std::ranges::count(answers_.outcomes, c)); }

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
