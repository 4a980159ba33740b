#include <core/analysis/design/judge_all.hpp>
#include <core/analysis/design/trials.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::analysis {

Trials::Trials(const DesignProblem& problem, std::size_t most, const Progress& progress)
    : problem_(problem), most_(most), progress_(progress) {}

const Trial* Trials::known(const std::vector<double>& values) const {
  const auto found = index_.find(values);
  return found != index_.end() ? &trials_[found->second] : nullptr;
}

const Trial& Trials::add(std::vector<double> values, Judged judged, const std::string& by) {
  index_.emplace(values, trials_.size());
  trials_.push_back({std::move(values), std::move(judged), by});
  return trials_.back();
}

void Trials::tell() const { progress_.say(fmt::format("{} of at most {} variants", trials_.size(), most_)); }

const Trial* Trials::at(const std::vector<double>& values, const std::string& by) {
  if (const Trial* t = known(values)) return t;
  if (left() == 0) return nullptr;
  progress_.stop_if_asked();
  const Trial& out = add(values, problem_.judge(values), by);
  tell();
  return &out;
}

void Trials::at_all(const std::vector<std::vector<double>>& values, const std::string& by) {
  std::vector<std::vector<double>> fresh;
  for (const std::vector<double>& v : values)
    if (fresh.size() < left() && known(v) == nullptr && std::ranges::find(fresh, v) == fresh.end()) fresh.push_back(v);
  chunks::Meaning meaning;
  for (const std::vector<double>& v : fresh)
    for (const double x : v) meaning << x;
  // What is tried next depends on what these come to, wherever the search goes on.
  std::vector<Judged> judged = judge_all(
      {fmt::format("{} trials from {}", progress_.part, trials_.size()), meaning.value(), 0, true}, fresh.size(),
      [&](std::size_t k) { return problem_.judge(fresh[k]); }, progress_);
  for (std::size_t k = 0; k < fresh.size(); ++k) add(std::move(fresh[k]), std::move(judged[k]), by);
  tell();
}

std::vector<double> Trials::values_of(const std::vector<double>& unit) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const DesignVariable& v = problem_.variables[i];
    // The ends as they were given, without the rounding of the sum.
    out.push_back(unit[i] >= 1 ? v.to : unit[i] <= 0 ? v.from : v.from + (v.to - v.from) * unit[i]);
  }
  return out;
}

std::vector<double> Trials::unit_of(const std::vector<double>& values) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DesignVariable& v = problem_.variables[i];
    out.push_back(std::clamp((values[i] - v.from) / (v.to - v.from), 0.0, 1.0));
  }
  return out;
}

std::optional<std::size_t> Trials::best(const DesignGoal& goal, std::size_t first, const std::vector<DesignConstraint>& also) const {
  std::optional<std::size_t> out;
  for (std::size_t k = first; k < trials_.size(); ++k) {
    const Judged& j = trials_[k].judged;
    if (!problem_.feasible(j) || violation(also, j) > 0) continue;
    if (!out || problem_.cost(goal, j) < problem_.cost(goal, trials_[*out].judged)) out = k;
  }
  return out;
}

std::optional<std::size_t> Trials::nearest(std::size_t first, const std::vector<DesignConstraint>& also) const {
  std::optional<std::size_t> out;
  double least = 0;
  for (std::size_t k = first; k < trials_.size(); ++k) {
    const Judged& j = trials_[k].judged;
    if (!problem_.usable(j)) continue;
    const double broken = violation(problem_.constraints, j) + violation(also, j);
    if (!out || broken < least) out = k, least = broken;
  }
  return out;
}

}  // namespace pmreport::analysis
