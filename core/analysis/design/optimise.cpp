#include <core/analysis/design/optimise.hpp>

#include <core/analysis/spread.hpp>
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

LocalMethod other(LocalMethod m) { return m == LocalMethod::simplex ? LocalMethod::linear_models : LocalMethod::simplex; }

// Of the usable trials from `first` on, those that keep the constraints before those that break them, and the better before the worse; none
// that lies within a tenth of every range of one before it, for a search from there would end where that one does.
std::vector<std::vector<double>> starts(const Trials& trials, const DesignGoal& goal, std::size_t first) {
  constexpr double apart = 0.1;
  const DesignProblem& p = trials.problem();
  std::vector<std::pair<double, double>> rank;  // what is broken, then the cost
  std::vector<std::size_t> order;
  for (std::size_t k = first; k < trials.all().size(); ++k) {
    const Judged& j = trials.all()[k].judged;
    const bool usable = p.usable(j);
    rank.emplace_back(usable ? violation(p.constraints, j) : 0.0, usable ? p.cost(goal, j) : 0.0);
    if (usable) order.push_back(k);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank[a - first] < rank[b - first]; });
  std::vector<std::vector<double>> out;
  for (const std::size_t k : order) {
    const std::vector<double> u = trials.unit_of(trials.all()[k].values);
    const bool near = std::ranges::any_of(out, [&](const std::vector<double>& v) {
      for (std::size_t i = 0; i < u.size(); ++i)
        if (std::abs(u[i] - v[i]) > apart) return false;
      return true;
    });
    if (!near) out.push_back(u);
  }
  return out;
}

}  // namespace

// Where a goal has several optima a search from one start finds the one nearest to it, and where constraints and failures crowd the range
// it may find none. So two searches that have nothing in common but the problem share the trials: one from the scenario's own values, the
// other from points that are spread over the whole range, the best first, and from the next as long as trials are left. The methods take
// turns: planes meet where constraints bind but end early in curved valleys; a simplex takes no model to be true, and is slow on an edge.
// What is left goes to the best end, until neither method gets on.
Optimum optimise(const DesignProblem& problem, std::size_t most, const Progress& progress) {
  PMREPORT_ASSERT(problem.goals.size() == 1 && most >= 10, "an optimum is of one goal, and is searched for by ten trials or more");
  const DesignGoal& goal = problem.goals.front();
  Trials trials(problem, most, progress);
  Optimum out;
  const std::vector<double> own = problem.own();
  out.own_inside = problem.inside(own);
  out.own = out.own_inside ? trials.at(own, "scenario")->judged : problem.judge(own);
  const std::size_t share = most * 2 / 5;

  out.first.how = fmt::format("{} from the scenario's own values", name_of(LocalMethod::linear_models));
  out.first.first = trials.all().size();
  search_from(trials.unit_of(own), goal, {.most = share}, trials, "first search");
  out.first.count = trials.all().size() - out.first.first;
  // The start is of the first search, although it was judged before.
  out.first.best = trials.best(goal);

  out.second.first = trials.all().size();
  std::vector<std::vector<double>> points;
  for (const std::vector<double>& u : spread(share / 2, own.size())) points.push_back(trials.values_of(u));
  trials.at_all(points, "spread");
  out.second.how = fmt::format("{} and {} in turn, from the best of {} points spread over the range", name_of(LocalMethod::simplex),
                               name_of(LocalMethod::linear_models), trials.all().size() - out.second.first);
  const std::size_t end = out.second.first + share;
  LocalMethod method = LocalMethod::simplex;
  for (const std::vector<double>& start : starts(trials, goal, out.second.first)) {
    if (trials.all().size() >= end) break;
    search_from(start, goal, {.method = method, .most = end - trials.all().size(), .step = 0.08, .accuracy = 1e-4}, trials,
                "second search");
    method = other(method);
  }
  out.second.count = trials.all().size() - out.second.first;
  out.second.best = trials.best(goal, out.second.first);
  compare(trials, goal, out);

  out.polish.first = trials.all().size();
  out.polish.how = "both in turn, from the better end";
  int idle = 0;
  method = out.first.best && trials.best(goal) == out.first.best ? LocalMethod::simplex : LocalMethod::linear_models;
  for (auto best = trials.best(goal); best && idle < 2 && trials.left() > 0; method = other(method)) {
    search_from(trials.unit_of(trials.all()[*best].values), goal, {.method = method, .most = trials.left(), .step = 0.04}, trials,
                "polish");
    const auto now = trials.best(goal);
    idle = now == best ? idle + 1 : 0;
    best = now;
  }
  out.polish.count = trials.all().size() - out.polish.first;
  out.polish.best = trials.best(goal, out.polish.first);

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
