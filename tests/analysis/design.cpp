// Searches for the best variant, fronts between two goals and sweeps, on functions whose answers are known in closed form.
#include <catch2/catch.hpp>

#include <core/analysis/design/front.hpp>
#include <core/analysis/design/optimise.hpp>
#include <core/analysis/design/sweep.hpp>
#include <core/analysis/spread.hpp>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace pmreport::analysis;

namespace {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

// Functions as the numbers of variants; where one is NaN the variant has no value there.
Judge judge_of(std::vector<Function> functions) {
  return [functions](const Point& x) {
    Judged out;
    for (const Function& f : functions) out.numbers.push_back(Bracketed::plain(f(x)));
    return out;
  };
}

DesignProblem problem_of(std::vector<DesignVariable> variables, std::vector<DesignGoal> goals, std::vector<DesignConstraint> constraints,
                         std::vector<Function> functions) {
  DesignProblem p{std::move(variables), std::move(goals), std::move(constraints), judge_of(std::move(functions)), {}};
  p.confirm = p.judge;
  return p;
}

double rosenbrock(const Point& x) { return 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2); }

const Trial& best_of(const Optimum& o) {
  REQUIRE(o.best);
  return o.trials[*o.best];
}

// What any optimum must keep, whatever the function: judged by the trials themselves.
void check_honest(const DesignProblem& p, const Optimum& o, std::size_t most) {
  CHECK(o.trials.size() <= most);
  std::set<Point> seen;
  for (const Trial& t : o.trials) {
    CHECK(seen.insert(t.values).second);  // nothing is judged twice
    for (std::size_t i = 0; i < t.values.size(); ++i) {
      CHECK(t.values[i] >= p.variables[i].from);
      CHECK(t.values[i] <= p.variables[i].to);
    }
    if (o.best && p.feasible(t.judged)) CHECK(p.cost(p.goals[0], t.judged) >= p.cost(p.goals[0], best_of(o).judged));  // and none is better
  }
  if (o.best) CHECK(p.feasible(best_of(o).judged));
}

}  // namespace

TEST_CASE("a spread is Halton's sequence: of any 8 neighbours one lies in each eighth, of any 9 one in each ninth") {
  const auto points = spread(72, 2);
  CHECK(points[0] == Point{1.0 / 2, 1.0 / 3});
  CHECK(points[1][0] == 0.25);
  CHECK(points[1][1] == Approx(2.0 / 3));
  CHECK(points[2][1] == Approx(1.0 / 9));
  for (const auto& [coordinate, parts] : {std::pair<std::size_t, std::size_t>{0, 8}, {1, 9}})
    for (std::size_t first = 0; first + parts <= points.size(); ++first) {
      std::set<int> met;
      // A hundred-millionth moves a third that was rounded downward into its own part.
      for (std::size_t k = first; k < first + parts; ++k)
        met.insert(static_cast<int>(points[k][coordinate] * static_cast<double>(parts) + 1e-8));
      CHECK(met.size() == parts);
    }
}

TEST_CASE("Rosenbrock's valley within a disk has its optimum at (1, 1), on the rim") {
  const DesignProblem p = problem_of({{"x", -1.5, 1.5, -1}, {"y", -1.5, 1.5, 0.5}}, {{0, false}}, {{1, true, 2}},
                                     {rosenbrock, [](const Point& x) { return x[0] * x[0] + x[1] * x[1]; }});
  const Optimum o = optimise(p, 400, {});
  check_honest(p, o, 400);
  // Along the valley the function grows as (1 - x)^2: a thousandth of it is left 0.03 from the optimum.
  CHECK(best_of(o).judged.numbers[0].value < 1e-3);
  CHECK(best_of(o).values[0] == Approx(1).margin(0.035));
  CHECK(best_of(o).values[1] == Approx(1).margin(0.07));
  CHECK(o.own.numbers[0].value == Approx(29));
  CHECK(o.own_inside);
}

TEST_CASE("the least perimeter of a given area is a square, and its constraint is told to bind") {
  const DesignProblem p = problem_of({{"a", 0.2, 5, 4}, {"b", 0.2, 5, 3}}, {{0, false}}, {{1, false, 1}},
                                     {[](const Point& x) { return 2 * (x[0] + x[1]); }, [](const Point& x) { return x[0] * x[1]; }});
  const Optimum o = optimise(p, 200, {});
  check_honest(p, o, 200);
  // Near the square the perimeter grows with the square of the distance, and with the first power of the slack in the area.
  CHECK(best_of(o).judged.numbers[0].value == Approx(4).epsilon(1e-4));
  CHECK(best_of(o).values[0] == Approx(1).epsilon(0.02));
  CHECK(active(p.constraints[0], best_of(o).judged));
  CHECK_FALSE(active(p.constraints[0], o.own));
  CHECK(o.agreement == Agreement::agree);
  CHECK(at_bounds(p, best_of(o).values) == std::vector<int>{0, 0});
}

TEST_CASE("the nearest point of a box to any other is that one clamped, and the sides that bind are told") {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> anywhere(-1, 2), inside(0.1, 0.9);
  for (int round = 0; round < 10; ++round) {
    const Point centre{anywhere(random), anywhere(random), anywhere(random)};
    CAPTURE(round, centre);
    DesignProblem p = problem_of({{"x", 0, 1, inside(random)}, {"y", 0, 1, inside(random)}, {"z", 0, 1, inside(random)}}, {{0, true}}, {},
                                 {[&](const Point& x) {
                                   double sum = 0;
                                   for (std::size_t i = 0; i < 3; ++i) sum += std::pow(x[i] - centre[i], 2);
                                   return -sum;
                                 }});
    const Optimum o = optimise(p, 200, {});
    check_honest(p, o, 200);
    const std::vector<int> bound = at_bounds(p, best_of(o).values);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(best_of(o).values[i] == Approx(std::clamp(centre[i], 0.0, 1.0)).margin(0.01));
      // So far beyond a side that a search is driven onto it.
      if (centre[i] < -0.05) CHECK(bound[i] == -1);
      if (centre[i] > 1.05) CHECK(bound[i] == 1);
      if (centre[i] > 0.05 && centre[i] < 0.95) CHECK(bound[i] == 0);
    }
  }
}

TEST_CASE("two wells are told as two optima, whichever of them the scenario starts in, and the deeper is taken") {
  // Depth 1 at x = 0.2, 2 at x = 0.8, neither felt at the other.
  const auto wells = [](const Point& x) {
    return -std::exp(-std::pow((x[0] - 0.2) / 0.08, 2)) - 2 * std::exp(-std::pow((x[0] - 0.8) / 0.08, 2));
  };
  const DesignProblem p = problem_of({{"x", 0, 1, 0.25}}, {{0, false}}, {}, {wells});
  const Optimum o = optimise(p, 60, {});
  check_honest(p, o, 60);
  CHECK(best_of(o).values[0] == Approx(0.8).margin(0.002));
  CHECK(o.agreement == Agreement::different);
  CHECK(o.apart == Approx(0.5).margin(0.01));
  CHECK(o.away == Approx(0.6).margin(0.01));

  const DesignProblem even = problem_of({{"x", 0, 1, 0.25}}, {{0, false}}, {}, {[&](const Point& x) {
                                          return -std::exp(-std::pow((x[0] - 0.2) / 0.08, 2)) - std::exp(-std::pow((x[0] - 0.8) / 0.08, 2));
                                        }});
  const Agreement found = optimise(even, 60, {}).agreement;
  CHECK((found == Agreement::flat || found == Agreement::agree));
}

TEST_CASE("values that lie within each other's brackets are no two optima") {
  DesignProblem p = problem_of({{"x", 0, 1, 0.25}}, {{0, false}}, {}, {});
  p.judge = p.confirm = [](const Point& x) {
    const double f = -std::exp(-std::pow((x[0] - 0.2) / 0.08, 2)) - 1.1 * std::exp(-std::pow((x[0] - 0.8) / 0.08, 2));
    return Judged{{Bracketed{f, f - 0.2, f + 0.2}}};
  };
  CHECK(optimise(p, 60, {}).agreement == Agreement::flat);
}

TEST_CASE("variants that cannot be made are passed by, and the optimum is found on their rim") {
  DesignProblem p = problem_of({{"x", 0, 1, 0.2}, {"y", 0, 1, 0.2}}, {{0, true}}, {}, {});
  p.judge = p.confirm = [](const Point& x) {
    if (x[0] + x[1] > 1) return Judged{{}, "it falls apart"};
    return Judged{{Bracketed::plain(x[0] * x[1])}};
  };
  const Optimum o = optimise(p, 200, {});
  check_honest(p, o, 200);
  CHECK(best_of(o).judged.numbers[0].value == Approx(0.25).epsilon(0.01));
  CHECK(std::ranges::count_if(o.trials, [](const Trial& t) { return t.judged.why == "it falls apart"; }) > 10);
}

TEST_CASE("where no variant can be made, or none has a number, there is no best and none that is near") {
  DesignProblem p = problem_of({{"x", 0, 1, 0.5}}, {{0, true}}, {{0, true, 1}}, {[](const Point&) { return std::nan(""); }});
  for (const bool made : {true, false}) {
    if (!made) p.judge = p.confirm = [](const Point&) { return Judged{{}, "no"}; };
    const Optimum o = optimise(p, 50, {});
    CHECK_FALSE(o.best);
    CHECK_FALSE(o.nearest);
    CHECK(o.agreement == Agreement::neither);
    CHECK(o.trials.size() >= 10);
    CHECK(o.trials.size() <= 50);
  }
}

TEST_CASE("constraints that nothing keeps leave the variant that breaks them least") {
  const DesignProblem p = problem_of({{"x", 0, 1, 0.5}}, {{0, false}}, {{0, false, 2}}, {[](const Point& x) { return x[0]; }});
  const Optimum o = optimise(p, 50, {});
  CHECK_FALSE(o.best);
  REQUIRE(o.nearest);
  CHECK(o.trials[*o.nearest].values[0] == Approx(1).margin(1e-3));
  CHECK(violation(p.constraints, o.trials[*o.nearest].judged) == Approx(0.5).margin(1e-3));
}

TEST_CASE("a constraint is kept by all of a bracket or not at all") {
  const DesignConstraint below{0, true, 10}, above{0, false, 10};
  const auto with = [](double low, double high) { return Judged{{Bracketed::between(low, high)}}; };
  CHECK(below.slack(with(8, 9)) == 1);
  CHECK(below.slack(with(9, 10)) == 0);
  CHECK(below.slack(with(9, 11)) == -1);
  CHECK(above.slack(with(9, 11)) == -1);
  CHECK(above.slack(with(12, 13)) == 2);
  CHECK(violation({below, above}, with(9, 12)) == Approx(0.2 + 0.1));
}

TEST_CASE("brackets tell which number is the larger, or leave it open") {
  CHECK(order_of(Bracketed::between(1, 2), Bracketed::between(2.1, 3)) == Order::less);
  CHECK(order_of(Bracketed::between(2.1, 3), Bracketed::between(1, 2)) == Order::greater);
  CHECK(order_of(Bracketed::between(1, 2), Bracketed::between(2, 3)) == Order::open);
  CHECK(order_of(Bracketed::plain(2), Bracketed::plain(2)) == Order::equal);
  CHECK(order_of(Bracketed::plain(2), Bracketed{}) == Order::open);
}

TEST_CASE("own values outside the bounds are judged all the same, and the search stays inside") {
  const DesignProblem p = problem_of({{"x", 0, 1, 3}}, {{0, true}}, {}, {[](const Point& x) { return x[0]; }});
  const Optimum o = optimise(p, 40, {});
  check_honest(p, o, 40);
  CHECK_FALSE(o.own_inside);
  CHECK(o.own.numbers[0].value == 3);
  CHECK(best_of(o).values[0] == 1);
  CHECK(at_bounds(p, best_of(o).values) == std::vector<int>{1});
}

TEST_CASE("what stops a run passes through a search, and so does what a judge throws") {
  struct Stopped {};
  const DesignProblem p = problem_of({{"x", 0, 1, 0.5}}, {{0, true}}, {}, {[](const Point& x) { return x[0]; }});
  int asked = 0;
  Progress progress;
  progress.stop_if_asked = [&] {
    if (++asked == 7) throw Stopped();
  };
  CHECK_THROWS_AS(optimise(p, 40, progress), Stopped);
  DesignProblem broken = p;
  broken.judge = [](const Point& x) {
    if (x[0] != 0.5) throw Stopped();
    return Judged{{Bracketed::plain(1)}};
  };
  CHECK_THROWS_AS(optimise(broken, 40, {}), Stopped);
}

TEST_CASE("one thread and several try the same variants in the same order") {
  const DesignProblem p = problem_of({{"x", -1.5, 1.5, -1}, {"y", -1.5, 1.5, 0.5}}, {{0, false}}, {{1, true, 2}},
                                     {rosenbrock, [](const Point& x) { return x[0] * x[0] + x[1] * x[1]; }});
  std::vector<std::vector<Point>> runs;
  for (const std::size_t threads : {1, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    runs.emplace_back();
    for (const Trial& t : optimise(p, 120, {}).trials) runs.back().push_back(t.values);
  }
  CHECK(runs[0] == runs[1]);
}

TEST_CASE("a sweep has both ends of every range, the last variable fastest, and loses no variant") {
  const Judge judge = [](const Point& x) {
    if (x[0] == 0.3 && x[1] == 1) return Judged{{}, "refused"};
    return Judged{{Bracketed::plain(10 * x[0] + x[1])}};
  };
  const Sweep s = sweep({{0.1, 0.3, 3}, {1, 7, 4}}, judge, {});
  REQUIRE(s.values.size() == 12);
  CHECK(s.values[0] == Point{0.1, 1});
  CHECK(s.values[1] == Point{0.1, 3});
  CHECK(s.values[11] == Point{0.3, 7});
  for (std::size_t k = 0; k < 12; ++k) {
    if (k == 8)
      CHECK(s.judged[k].why == "refused");
    else
      CHECK(s.judged[k].numbers[0].value == 10 * s.values[k][0] + s.values[k][1]);
  }
}
