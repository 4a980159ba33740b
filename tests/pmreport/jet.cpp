#include <array>
#include <catch2/catch.hpp>
#include <pmreport/jet.hpp>
#include <tests/pmreport/functions.hpp>

using namespace pmreport;
using functions::Random;

namespace {

constexpr int jet_tries = 50;

// First and second derivative at 0, by differences of the sixth order in extended precision: with this step their own errors, of truncation
// and of rounding (1e-19 / h^2), stay below 1e-12 for the functions tried.
template <class F>
std::array<long double, 2> differences(F&& f) {
  constexpr long double h = 0x1p-8L;
  const auto even = [&](int k) { return f(k * h) + f(-k * h); };
  const auto odd = [&](int k) { return f(k * h) - f(-k * h); };
  return {(45 * odd(1) - 9 * odd(2) + odd(3)) / (60 * h), (270 * even(1) - 27 * even(2) + 2 * even(3) - 490 * f(0.0L)) / (180 * h * h)};
}
constexpr double jet_difference_tolerance = 1e-9;
constexpr double jet_rounding = 1e-13;

// A motion through x0 with rate and acceleration, and its jet.
struct Motion {
  double value, rate, acceleration;
  Jet<double> jet() const { return {value, rate, acceleration}; }
  long double at(long double t) const { return value + rate * t + acceleration * t * t / 2; }
};
Motion random_motion(Random& random, double min, double max) {
  return {random.within(min, max), random.within(-1, 1), random.within(-2, 2)};
}

Approx near_jet(long double expected, double tolerance) { return Approx(double(expected)).epsilon(tolerance).margin(tolerance); }

void check(const Jet<double>& seen, long double value, const std::array<long double, 2>& derivatives) {
  CHECK(seen.value == near_jet(value, jet_rounding));
  CHECK(seen.rate == near_jet(derivatives[0], jet_difference_tolerance));
  CHECK(seen.acceleration == near_jet(derivatives[1], jet_difference_tolerance));
}
void check(const Jet<double>& seen, const Jet<double>& expected) {
  CHECK(seen.value == near_jet(expected.value, jet_rounding));
  CHECK(seen.rate == near_jet(expected.rate, jet_rounding));
  CHECK(seen.acceleration == near_jet(expected.acceleration, jet_rounding));
}

}  // namespace

TEST_CASE("a jet's rate and acceleration are those that differences in time show") {
  Random random(1);
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < jet_tries; ++i) {
      const Motion x = random_motion(random, min, max);
      CAPTURE(name, x.value, x.rate, x.acceleration);
      check(f(x.jet()), f(x.at(0)), differences([&](long double t) { return f(x.at(t)); }));
    }
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < jet_tries; ++i) {
      const Motion x = random_motion(random, min, max), y = random_motion(random, min, max);
      CAPTURE(name, x.value, x.rate, x.acceleration, y.value, y.rate, y.acceleration);
      check(f(x.jet(), y.jet()), f(x.at(0), y.at(0)), differences([&](long double t) { return f(x.at(t), y.at(t)); }));
    }
  });
}

TEST_CASE("jets of powers of time are those of calculus") {
  for (const double t : {0.5, 1.0, 1.5, -2.0}) {
    CAPTURE(t);
    const Jet<double> x(t, 1, 0);
    check(x * x * x, Jet<double>(t * t * t, 3 * t * t, 6 * t));
    check(1.0 / x, Jet<double>(1 / t, -1 / (t * t), 2 / (t * t * t)));
    check(x * x / x, x);
  }
  check(sqrt(Jet<double>(4, 1, 0)), Jet<double>(2, 0.25, -1.0 / 32));
}

TEST_CASE("jets keep the identities of their functions") {
  Random random(2);
  for (int i = 0; i < jet_tries; ++i) {
    const Jet<double> x = random_motion(random, 0.2, 0.8).jet(), r = random_motion(random, 0.5, 2).jet();
    CAPTURE(x.value, x.rate, x.acceleration, r.value, r.rate, r.acceleration);
    const Jet<double> sine = sin(x), cosine = cos(x);
    check(sine * sine + cosine * cosine, Jet<double>(1.0));
    check(tan(x), sine / cosine);
    check(asin(sine), x);
    check(acos(cosine), x);
    check(atan2(r * sine, r * cosine), x);
    check(hypot(r * sine, r * cosine), r);
    check(sqrt(r) * sqrt(r), r);
    check(asin(x) + acos(x), Jet<double>(std::acos(0.0)));
  }
}

TEST_CASE("a constant does not move") {
  const Jet<double> c = 3.5;
  CHECK(c.value == 3.5);
  CHECK(c.rate == 0);
  CHECK(c.acceleration == 0);
}

TEST_CASE("abs, smaller and larger of jets follow the branch of the value") {
  const Jet<double> a(-1, 2, 3), b(2, 5, 7);
  check(abs(a), -a);
  check(abs(b), b);
  check(smaller(a, b), a);
  check(smaller(b, a), a);
  check(larger(a, b), b);
  check(larger(b, a), b);
  check(choose(true, a, b), a);
  check(choose(false, a, b), b);
}
