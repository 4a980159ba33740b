#include <core/analysis/design/front.hpp>

#include <core/analysis/spread.hpp>
#include <core/assertion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

namespace {

// Indices of the trials that none dominates, rising in the cost of the first goal; of two that are equal in both the earlier.
std::vector<std::size_t> front_of(const DesignProblem& p, const std::deque<Trial>& trials, std::size_t& dominated) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < trials.size(); ++k)
    if (p.feasible(trials[k].judged)) order.push_back(k);
  const auto cost = [&](std::size_t k, std::size_t goal) { return p.cost(p.goals[goal], trials[k].judged); };
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return cost(a, 0) != cost(b, 0) ? cost(a, 0) < cost(b, 0) : cost(a, 1) < cost(b, 1); });
  std::vector<std::size_t> out;
  for (const std::size_t k : order)
    if (out.empty() || cost(k, 1) < cost(out.back(), 1)) out.push_back(k);
  dominated = order.size() - out.size();
  return out;
}

// Levels of the second number at which a front of so many points is spaced evenly along it, each goal over its range counting alike; the
// ends of the front are none.
std::vector<double> levels_of(const DesignProblem& p, const std::deque<Trial>& trials, const std::vector<std::size_t>& all,
                              std::size_t points) {
  const auto number = [&](std::size_t i, std::size_t goal) { return trials[all[i]].judged.numbers[p.goals[goal].measure].value; };
  const std::size_t last = all.size() - 1;
  const double range[] = {number(last, 0) - number(0, 0), number(last, 1) - number(0, 1)};
  std::vector<double> along{0};
  for (std::size_t i = 1; i <= last; ++i)
    along.push_back(along.back() + std::hypot((number(i, 0) - number(i - 1, 0)) / range[0], (number(i, 1) - number(i - 1, 1)) / range[1]));
  std::vector<double> out;
  std::size_t i = 1;
  for (std::size_t k = 1; k + 1 < points; ++k) {
    const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(points - 1);
    while (i < last && along[i] < wanted) ++i;
    const double share = (wanted - along[i - 1]) / (along[i] - along[i - 1]);
    out.push_back(number(i - 1, 1) + share * (number(i, 1) - number(i - 1, 1)));
  }
  return out;
}

}  // namespace

bool dominates(const DesignProblem& problem, const Judged& better, const Judged& worse) {
  bool one = false;
  for (const DesignGoal& g : problem.goals) {
    const double a = problem.cost(g, better), b = problem.cost(g, worse);
    if (a > b) return false;
    one = one || a < b;
  }
  return one;
}

// By levels of the second goal (Haimes, Lasdon and Wismer 1971): each goal alone gives an end of the front; between them the first goal is
// searched for while the second must not fall behind a level. Weighted sums would miss the parts of a front that curve inward. Points
// spread over the range come first, so that every search has a start that is good already. The levels are even along the front as it is
// known, and are set anew when the first round has shown its course.
Front front(const DesignProblem& problem, std::size_t points, std::size_t most, const Progress& progress) {
  PMREPORT_ASSERT(problem.goals.size() == 2 && points >= 3 && most >= 10 * points,
                  "a front is of two goals, has three points or more and ten trials for each");
  Trials trials(problem, most, progress);
  Front out;
  const std::vector<double> own = problem.own();
  out.own_inside = problem.inside(own);
  out.own = out.own_inside ? trials.at(own, "scenario")->judged : problem.judge(own);

  std::vector<std::vector<double>> values;
  for (const std::vector<double>& u : spread(most / 6, own.size())) values.push_back(trials.values_of(u));
  trials.at_all(values, "spread");

  const auto search = [&](const DesignGoal& goal, const LocalSearch& how, const std::string& by) {
    auto from = trials.best(goal, 0, how.also);
    if (!from) from = trials.nearest(0, how.also);
    if (from) search_from(trials.unit_of(trials.all()[*from].values), goal, how, trials, by);
  };
  const DesignGoal &first = problem.goals[0], &second = problem.goals[1];
  for (const DesignGoal* goal : {&first, &second})
    for (const auto& [method, step] : {std::pair{LocalMethod::linear_models, 0.1}, {LocalMethod::simplex, 0.05}})
      search(*goal, {.method = method, .most = most / 16, .step = step}, "end of the front");

  std::vector<std::vector<DesignConstraint>> levels;
  std::vector<std::size_t> all = front_of(problem, trials.all(), out.dominated);
  for (const double step : {0.08, 0.03}) {
    if (all.size() < 2) break;
    levels.clear();
    for (const double level : levels_of(problem, trials.all(), all, points)) levels.push_back({{second.measure, !second.maximise, level}});
    const std::size_t round = step == 0.08 ? trials.left() / 2 : trials.left();
    for (std::size_t k = 0; k < levels.size(); ++k)
      search(first, {.most = round / levels.size(), .step = step, .also = levels[k]}, fmt::format("level {}", k + 1));
    all = front_of(problem, trials.all(), out.dominated);
  }

  // The ends, and above each level the best of the first goal, with which the front begins.
  std::vector<std::size_t> kept;
  const auto keep = [&](std::size_t trial) {
    if (std::ranges::find(kept, trial) == kept.end()) kept.push_back(trial);
  };
  if (!all.empty()) keep(all.front());
  for (const auto& level : levels)
    for (const std::size_t k : all)
      if (violation(level, trials.all()[k].judged) == 0) {
        keep(k);
        break;
      }
  if (!all.empty()) keep(all.back());
  out.thinned = all.size() - kept.size();
  std::vector<FrontPoint> confirmed;
  for (const std::size_t k : kept) confirmed.push_back({k, problem.confirm(trials.all()[k].values)});
  for (const FrontPoint& p : confirmed) {
    const bool beaten = !problem.feasible(p.confirmed) || std::ranges::any_of(confirmed, [&](const FrontPoint& q) {
      return problem.feasible(q.confirmed) && dominates(problem, q.confirmed, p.confirmed);
    });
    if (beaten)
      ++out.dropped;
    else
      out.points.push_back(p);
  }
  if (out.points.empty()) out.nearest = trials.nearest();
  out.trials.assign(trials.all().begin(), trials.all().end());
  return out;
}

}  // namespace pmreport::analysis
