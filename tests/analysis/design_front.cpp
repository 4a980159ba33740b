// Fronts between two goals, against those that are known in closed form.
#include <catch2/catch.hpp>

#include <core/analysis/design/front.hpp>

#include <algorithm>
#include <cmath>

using namespace pmreport::analysis;

namespace {

using Variables = std::vector<double>;
using OfVariables = std::function<double(const Variables&)>;

DesignProblem problem_of(std::vector<DesignVariable> variables, bool maximise, std::vector<DesignConstraint> constraints,
                         std::vector<OfVariables> functions) {
  DesignProblem p{std::move(variables), {{0, maximise}, {1, maximise}}, std::move(constraints), {}, {}};
  p.judge = p.confirm = [functions](const Variables& x) {
    Judged out;
    for (const OfVariables& f : functions) out.numbers.push_back(Bracketed::plain(f(x)));
    return out;
  };
  return p;
}

double number(const FrontPoint& p, std::size_t k) { return p.confirmed.numbers[k].value; }

// What any front must keep: none of its points dominates another, and none of all trials dominates one.
void check_front(const DesignProblem& p, const Front& f, std::size_t points, std::size_t most) {
  CHECK(f.points.size() <= points);
  CHECK(f.trials.size() <= most);
  for (const FrontPoint& a : f.points) {
    CHECK(p.feasible(a.confirmed));
    for (const Trial& t : f.trials)
      if (p.feasible(t.judged)) CHECK_FALSE(dominates(p, t.judged, a.confirmed));
  }
}

// The largest gap between neighbours, of the range of each number.
double largest_gap(const Front& f) {
  double gap = 0;
  const double range[] = {number(f.points.front(), 0) - number(f.points.back(), 0),
                          number(f.points.front(), 1) - number(f.points.back(), 1)};
  for (std::size_t i = 1; i < f.points.size(); ++i)
    gap = std::max(gap, std::hypot((number(f.points[i], 0) - number(f.points[i - 1], 0)) / range[0],
                                   (number(f.points[i], 1) - number(f.points[i - 1], 1)) / range[1]));
  return gap;
}

}  // namespace

TEST_CASE("the front of x and y within a circle is the quarter of the circle between its ends") {
  const DesignProblem p = problem_of({{"x", 0, 1, 0.2}, {"y", 0, 1, 0.3}}, true, {{2, true, 1}},
                                     {[](const Variables& x) { return x[0]; }, [](const Variables& x) { return x[1]; },
                                      [](const Variables& x) { return x[0] * x[0] + x[1] * x[1]; }});
  const Front f = front(p, 9, 400, {});
  check_front(p, f, 9, 400);
  REQUIRE(f.points.size() >= 7);
  for (const FrontPoint& q : f.points) {
    const double radius = std::hypot(number(q, 0), number(q, 1));
    CAPTURE(number(q, 0), number(q, 1));
    CHECK(radius <= 1);
    CHECK(radius > 0.995);
  }
  CHECK(number(f.points.front(), 0) == Approx(1).margin(2e-3));
  CHECK(number(f.points.back(), 1) == Approx(1).margin(2e-3));
  CHECK(largest_gap(f) < 0.4);  // a ninth of a quarter, as long as pi / 2, is 0.17
}

TEST_CASE("Fonseca and Fleming's front, which curves inward, has its middle as well as its ends") {
  // f = 1 - exp(-|x -+ c|^2), c = (1, 1) / sqrt 2: the best variants lie on the line between c and -c.
  const double c = 1 / std::sqrt(2.0);
  const auto f = [c](double sign) {
    return [c, sign](const Variables& x) { return 1 - std::exp(-std::pow(x[0] - sign * c, 2) - std::pow(x[1] - sign * c, 2)); };
  };
  const DesignProblem p = problem_of({{"x", -2, 2, 1.5}, {"y", -2, 2, -1}}, false, {}, {f(1), f(-1)});
  const Front found = front(p, 9, 500, {});
  check_front(p, found, 9, 500);
  REQUIRE(found.points.size() >= 7);
  for (const FrontPoint& q : found.points) {
    // At distance a from c along the line the other is at 2 - a.
    const double a = std::sqrt(-std::log(1 - number(q, 0))), other = 1 - std::exp(-std::pow(2 - a, 2));
    CAPTURE(number(q, 0), number(q, 1), other);
    CHECK(number(q, 1) >= other - 1e-9);
    CHECK(number(q, 1) < other + 0.02);
  }
  CHECK(largest_gap(found) < 0.4);
}

TEST_CASE("a point that falls behind once it is confirmed leaves the front, and is counted") {
  DesignProblem p =
      problem_of({{"x", 0, 1, 0.5}}, true, {}, {[](const Variables& x) { return x[0]; }, [](const Variables& x) { return 1 - x[0]; }});
  p.confirm = [&](const Variables& x) {
    const double y = x[0] > 0.4 && x[0] < 0.6 ? 0.0 : 1 - x[0];
    return Judged{{Bracketed::plain(x[0]), Bracketed::plain(y)}};
  };
  const Front f = front(p, 9, 120, {});
  CHECK(f.dropped >= 1);
  CHECK(f.dropped + f.points.size() == 9);
  for (const FrontPoint& q : f.points) CHECK((number(q, 0) <= 0.4 || number(q, 0) >= 0.6));
  CHECK(f.thinned > 0);  // every trial lies on this front
  CHECK(f.dominated == 0);
}

TEST_CASE("a front that nothing may lie on is empty, with the variant that comes nearest") {
  const DesignProblem p = problem_of({{"x", 0, 1, 0.5}}, true, {{0, false, 2}},
                                     {[](const Variables& x) { return x[0]; }, [](const Variables& x) { return -x[0]; }});
  const Front f = front(p, 3, 30, {});
  CHECK(f.points.empty());
  REQUIRE(f.nearest);
  CHECK(f.trials[*f.nearest].values[0] == Approx(1).margin(0.01));
}
