#include <catch2/catch.hpp>
#include <cmath>
#include <core/scenario/motion/spline.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::scenario;

namespace {

struct Points {
  std::vector<double> times, values;
};
Points random_points(unsigned seed, std::size_t count) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> gap(0.2, 2), value(-1, 1);
  Points p;
  double t = 0;
  for (std::size_t i = 0; i < count; ++i, t += gap(generator)) {
    p.times.push_back(t);
    p.values.push_back(value(generator));
  }
  return p;
}

// The curve goes through its points, and value, rate and acceleration do not jump there. Between the two sides, `step` apart from the
// point, each changes by its derivative: the greatest is the third of a quintic over 0.2 s, at most 60 * 2 / 0.2^3 = 15000.
template <class Curve>
void check_smooth(const Curve& curve, const Points& p) {
  constexpr double step = 1e-10, change = 2 * step * 15000;
  for (std::size_t i = 0; i < p.times.size(); ++i) {
    const double t = p.times[i];
    CAPTURE(i, t);
    CHECK(curve.at(t).value == Approx(p.values[i]).margin(1e-13));
    if (i == 0 || i + 1 == p.times.size()) continue;
    const Jet<double> before = curve.at(t - step), after = curve.at(t + step);
    CHECK(after.value == Approx(before.value).margin(change));
    CHECK(after.rate == Approx(before.rate).margin(change));
    CHECK(after.acceleration == Approx(before.acceleration).margin(change));
  }
}

// Rates and accelerations against central differences; a cubic's own error there is nothing, a quintic's is h^2 times its fourth
// derivative.
template <class Curve>
void check_derivatives(const Curve& curve, const Points& p) {
  constexpr double h = 1e-4;
  for (std::size_t i = 0; i + 1 < p.times.size(); ++i)
    for (const double u : {0.13, 0.5, 0.77}) {
      const double t = p.times[i] + u * (p.times[i + 1] - p.times[i]);
      CAPTURE(t);
      CHECK(curve.at(t).rate == Approx((curve.at(t + h).value - curve.at(t - h).value) / (2 * h)).margin(1e-4));
      CHECK(curve.at(t).acceleration == Approx((curve.at(t + h).rate - curve.at(t - h).rate) / (2 * h)).margin(1e-3));
    }
}

}  // namespace

TEST_CASE("a cubic spline goes smoothly through its points") {
  for (const std::size_t count : {2u, 3u, 4u, 5u, 30u})
    for (const Ends ends : {Ends::at_rest, Ends::not_a_knot}) {
      const unsigned seed = static_cast<unsigned>(count);
      CAPTURE(seed, count, static_cast<int>(ends));
      const Points p = random_points(seed, count);
      const CubicSpline curve(p.times, p.values, ends);
      check_smooth(curve, p);
      check_derivatives(curve, p);
      if (ends == Ends::at_rest) {
        CHECK(std::abs(curve.at(p.times.front()).rate) < 1e-12);
        CHECK(std::abs(curve.at(p.times.back()).rate) < 1e-12);
      }
    }
}

TEST_CASE("a spline whose ends are no knots repeats a cubic") {
  const Points p = random_points(7, 9);
  const auto cubic = [](double t) { return 1 - 2 * t + 0.5 * t * t - 0.1 * t * t * t; };
  std::vector<double> values;
  for (const double t : p.times) values.push_back(cubic(t));
  const CubicSpline curve(p.times, values, Ends::not_a_knot);
  for (double t = p.times.front(); t < p.times.back(); t += 0.1) {
    CAPTURE(t);
    const double tolerance = 1e-10;  // roundings of values up to a hundred, differenced twice over steps of 0.2
    CHECK(curve.at(t).value == Approx(cubic(t)).margin(tolerance));
    CHECK(curve.at(t).rate == Approx(-2 + t - 0.3 * t * t).margin(tolerance));
    CHECK(curve.at(t).acceleration == Approx(1 - 0.6 * t).margin(tolerance));
  }
}

TEST_CASE("three points make a parabola, two a straight line") {
  const CubicSpline parabola({0, 1, 3}, {0, 1, 9}, Ends::not_a_knot);
  CHECK(parabola.at(2).value == Approx(4));
  CHECK(parabola.at(2).acceleration == Approx(2));
  const CubicSpline line({0, 2}, {1, 5}, Ends::not_a_knot);
  CHECK(line.at(0.5).value == Approx(2));
  CHECK(line.at(0.5).rate == Approx(2));
}

TEST_CASE("quintic steps rest at every point") {
  const Points p = random_points(3, 6);
  const QuinticSteps curve(p.times, p.values);
  check_smooth(curve, p);
  check_derivatives(curve, p);
  for (const double t : p.times) {
    CAPTURE(t);
    CHECK(std::abs(curve.at(t).rate) < 1e-12);
    CHECK(std::abs(curve.at(t).acceleration) < 1e-12);
  }
}

TEST_CASE("a spline knows how far it goes beyond its points") {
  // Against the largest of many points on the curve.
  for (const unsigned seed : {1u, 2u, 3u}) {
    const Points p = random_points(seed, 12);
    const CubicSpline curve(p.times, p.values, Ends::at_rest);
    double beyond = 0, when = 0;
    for (std::size_t i = 0; i + 1 < p.times.size(); ++i)
      for (int k = 0; k <= 2000; ++k) {
        const double t = p.times[i] + (p.times[i + 1] - p.times[i]) * k / 2000, y = curve.at(t).value;
        const auto [low, high] = std::minmax(p.values[i], p.values[i + 1]);
        if (const double x = std::max(y - high, low - y); x > beyond) beyond = x, when = t;
      }
    const CubicSpline::Overshoot o = curve.overshoot();
    CAPTURE(seed);
    CHECK(o.beyond == Approx(beyond).epsilon(1e-5));  // 2000 points a piece
    CHECK(o.time == Approx(when).margin(2e-3));
  }
  CHECK(CubicSpline({0, 1, 2, 3}, {0, 1, 2, 3}, Ends::not_a_knot).overshoot().beyond == 0);
}
