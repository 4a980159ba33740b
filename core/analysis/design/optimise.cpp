#include <core/analysis/design/optimise.hpp>

#include <core/analysis/design/spread.hpp>
#include <core/assertion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

constexpr double near_end = 1e-3;

void compare(const Trials& trials, const DesignGoal& goal, Optimum& out) {
  const auto &a = out.first.best, &b = out.second.best;
  if (!a || !b) {
    out.agreement = a || b ? Agreement::one_alone : Agreement::neither;
    return;
  }
  const Trial &one = trials.all()[*a], &other = trials.all()[*b];
  const Bracketed &x = one.judged.numbers[goal.measure], &y = other.judged.numbers[goal.measure];
  const double size = std::max(std::abs(x.value), std::abs(y.value));
  out.apart = size > 0 ? std::abs(x.value - y.value) / size : 0.0;
  const std::vector<double> u = trials.unit_of(one.values), v = trials.unit_of(other.values);
  for (std::size_t i = 0; i < u.size(); ++i) out.away = std::max(out.away, std::abs(u[i] - v[i]));
  // Numbers whose brackets meet, although not as plain ones, are not told apart.
  const bool open = order_of(x, y) == Order::open;
  out.agreement = out.apart > same_value && !open ? Agreement::different : out.away > same_place ? Agreement::flat : Agreement::agree;
}

}  // namespace

// Where a goal has several optima a search from one start finds the one nearest to it, and where constraints and failures crowd the range
// it may find none. So two searches that have nothing in common but the problem share the trials: one from the scenario's own values, the
// other from the best of points that are spread over the whole range; one by planes, which meet where constraints bind, the other by a
// simplex, which takes no model to be true. What is left goes to the better of their ends, by the method that did not find it: planes end
// early in curved valleys, and a simplex slowly on an edge.
Optimum optimise(const DesignProblem& problem, std::size_t most, const Progress& progress) {
  PMREPORT_ASSERT(problem.goals.size() == 1 && most >= 10, "an optimum is of one goal, and is searched for by ten trials or more");
  const DesignGoal& goal = problem.goals.front();
  Trials trials(problem, most, progress);
  Optimum out;
  const std::vector<double> own = problem.own();
  out.own_inside = problem.inside(own);
  out.own = out.own_inside ? trials.at(own, "scenario")->judged : problem.judge(own);

  const auto searched = [&](SearchEnd& end, std::string how, auto&& run) {
    end.how = std::move(how);
    end.first = trials.all().size();
    run();
    end.count = trials.all().size() - end.first;
  };
  const std::size_t half = most * 2 / 5;
  const std::vector<double> start = trials.unit_of(own);
  searched(out.first, fmt::format("{} from the scenario's own values", name_of(LocalMethod::linear_models)),
           [&] { search_from(start, goal, {.most = half}, trials, "first search"); });
  // The start is of the first search, although it was judged before.
  out.first.best = trials.best(goal);
  searched(out.second, fmt::format("{} from the best of points spread over the range", name_of(LocalMethod::simplex)), [&] {
    std::vector<std::vector<double>> values;
    for (const std::vector<double>& u : spread(half / 2, own.size())) values.push_back(trials.values_of(u));
    trials.at_all(values, "spread");
    auto from = trials.best(goal, out.second.first);
    if (!from) from = trials.nearest(out.second.first);
    if (from)
      search_from(trials.unit_of(trials.all()[*from].values), goal, {.method = LocalMethod::simplex, .most = half - half / 2, .step = 0.08},
                  trials, "second search");
  });
  out.second.best = trials.best(goal, out.second.first);
  compare(trials, goal, out);

  if (const auto best = trials.best(goal)) {
    const bool by_planes = *best < out.second.first;
    const LocalMethod other = by_planes ? LocalMethod::simplex : LocalMethod::linear_models;
    searched(out.polish, fmt::format("{} from the better of the two", name_of(other)), [&] {
      search_from(trials.unit_of(trials.all()[*best].values), goal, {.method = other, .most = trials.left(), .step = 0.04}, trials,
                  "polish");
    });
    out.polish.best = trials.best(goal, out.polish.first);
  }
  out.best = trials.best(goal);
  if (!out.best) out.nearest = trials.nearest();
  if (out.best) out.confirmed = problem.confirm(trials.all()[*out.best].values);
  out.trials.assign(trials.all().begin(), trials.all().end());
  return out;
}

std::vector<int> at_bounds(const DesignProblem& problem, const std::vector<double>& values) {
  std::vector<int> out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DesignVariable& v = problem.variables[i];
    const double slack = near_end * (v.to - v.from);
    out.push_back(values[i] <= v.from + slack ? -1 : values[i] >= v.to - slack ? 1 : 0);
  }
  return out;
}

bool active(const DesignConstraint& c, const Judged& j) {
  const double slack = c.slack(j);
  return slack >= 0 && slack < near_end * c.scale();
}

}  // namespace pmreport::analysis
