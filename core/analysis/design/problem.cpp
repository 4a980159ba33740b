#include <core/analysis/design/problem.hpp>

#include <algorithm>

namespace pmreport::analysis {

double violation(const std::vector<DesignConstraint>& constraints, const Judged& j) {
  double sum = 0;
  for (const DesignConstraint& c : constraints) sum += std::max(0.0, -c.slack(j) / c.scale());
  return sum;
}

bool DesignProblem::usable(const Judged& j) const {
  return j.made() && std::ranges::all_of(goals, [&](const DesignGoal& g) { return j.numbers[g.measure].known(); }) &&
         std::ranges::all_of(constraints, [&](const DesignConstraint& c) { return j.numbers[c.measure].known(); });
}

bool DesignProblem::feasible(const Judged& j) const {
  return usable(j) && std::ranges::all_of(constraints, [&](const DesignConstraint& c) { return c.slack(j) >= 0; });
}

double DesignProblem::cost(const DesignGoal& goal, const Judged& j) const {
  const double x = j.numbers[goal.measure].value;
  return goal.maximise ? -x : x;
}

std::vector<double> DesignProblem::own() const {
  std::vector<double> out;
  for (const DesignVariable& v : variables) out.push_back(v.own);
  return out;
}

bool DesignProblem::inside(const std::vector<double>& values) const {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= variables[i].from && values[i] <= variables[i].to)) return false;
  return true;
}

}  // namespace pmreport::analysis
