// Integrals over spans of time, against integrals that are known in closed form.
#include <catch2/catch.hpp>
#include <core/scenario/expression/behaviour.hpp>
#include <core/scenario/expression/integral_enclosure.hpp>
#include <memory>
#include <tests/scenario/enclosed.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace enclosed;

namespace {

// With numbers that have few digits in binary, so that both sides mean the same.
struct Known {
  const char* rate;
  At at;  // its integral from 0, itself, and its rate
  double end;
};
Real positive(Real x) { return x > 0 ? x : 0; }
Real sign(Real x) { return x < 0 ? -1 : 1; }
const Known all[] = {
    {"sin(0.75*t/1 s)",
     [](Real t) { return Jet<Real>((1 - std::cos(0.75L * t)) / 0.75L, std::sin(0.75L * t), 0.75L * std::cos(0.75L * t)); }, 10},
    {"cos(60*t/1 s)", [](Real t) { return Jet<Real>(std::sin(60 * t) / 60, std::cos(60 * t), -60 * std::sin(60 * t)); }, 10},
    {"exp(-t/4 s)", [](Real t) { return Jet<Real>(4 * -std::expm1(-t / 4), std::exp(-t / 4), -std::exp(-t / 4) / 4); }, 20},
    {"1/(1 + (t/1 s)^2)", [](Real t) { return Jet<Real>(std::atan(t), 1 / (1 + t * t), -2 * t / ((1 + t * t) * (1 + t * t))); }, 10},
    {"t/1 s * cos(t/1 s)",
     [](Real t) { return Jet<Real>(t * std::sin(t) + std::cos(t) - 1, t * std::cos(t), std::cos(t) - t * std::sin(t)); }, 10},
    {"(t/1 s)^3 - 2*t/1 s + 0.5",
     [](Real t) { return Jet<Real>(t * t * t * t / 4 - t * t + t / 2, t * t * t - 2 * t + 0.5L, 3 * t * t - 2); }, 3},
    {"tanh(t/1 s - 2)",
     [](Real t) {
       return Jet<Real>(std::log(std::cosh(t - 2) / std::cosh(2.0L)), std::tanh(t - 2), 1 / (std::cosh(t - 2) * std::cosh(t - 2)));
     },
     5},
    {"max(0, t/1 s - 1.5)",
     [](Real t) { return Jet<Real>(positive(t - 1.5L) * positive(t - 1.5L) / 2, positive(t - 1.5L), t < 1.5L ? 0 : 1); }, 4},
    {"abs(t/1 s - 1.1)",  // 1.1 as it is in binary
     [](Real t) { return Jet<Real>(((t - 1.1) * std::abs(t - 1.1) + Real(1.1) * Real(1.1)) / 2, std::abs(t - 1.1), sign(t - 1.1)); }, 4},
    {"abs(sin(4*t/1 s))",
     [](Real t) {
       const Real turns = std::floor(4 * t / 3.141592653589793238462643383279502884L);
       return Jet<Real>((2 * turns + 1 - std::cos(4 * t) * (std::fmod(turns, 2) == 0 ? 1 : -1)) / 4, std::abs(std::sin(4 * t)),
                        4 * std::cos(4 * t) * sign(std::sin(4 * t)));
     },
     10},
    {"sqrt(t/1 s)", [](Real t) { return Jet<Real>(2 * t * std::sqrt(t) / 3, std::sqrt(t), 0.5L / std::sqrt(t)); }, 4},
    {"1.25", [](Real t) { return Jet<Real>(1.25L * t, 1.25L, 0.0L); }, 10},
};

std::shared_ptr<const IntegralEnclosure> integral(const Known& k, double start = 0, double magnitude = 1) {
  const Expression rate = Expression::parse(k.rate, Time::allowed);
  const Behaviour b = behaviour(rate, 0, k.end);
  std::vector<double> times = b.steps;
  for (const Switch& s : b.switches) times.insert(times.end(), {s.before, s.after});
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return std::make_shared<const IntegralEnclosure>(rate, start, times, magnitude);
}
Over bounds_of(const Known& k) {
  return [f = integral(k)](Bounds span) { return f->over(span); };
}

}  // namespace

TEST_CASE("at every instant an integral is within its bounds over the span") {
  constexpr unsigned seed = 4;
  std::mt19937 generator(seed);
  for (const Known& k : all) {
    CAPTURE(seed, k.rate);
    const Escaped out = escaped(bounds_of(k), k.at, 0, k.end, 300, generator);
    INFO(out.first);
    CHECK(out.instants == 0);
    CHECK(out.unbounded == 0);
  }
}

TEST_CASE("an integral is known to a billionth of its range and better, kinks or none") {
  for (const Known& k : all) {
    CAPTURE(k.rate);
    const Over over = bounds_of(k);
    const Bounds whole = over({0, k.end}).value;
    for (const double share : {0.1, 0.25, 0.5, 0.77, 1.0})
      CHECK(over(Bounds::exactly(share * k.end)).value.width() < 1e-11 * whole.width());
  }
}

// Positive nodes and their weights, Abramowitz and Stegun, Table 25.4, n = 10; their last digits leave 1e-20.
Real by_gauss(const std::function<Real(Real)>& f, Real from, Real to, int panels) {
  constexpr Real nodes[] = {0.148874338981631210884826L, 0.433395394129247190799266L, 0.679409568299024406234327L,
                            0.865063366688984510732097L, 0.973906528517171720077964L},
                 weights[] = {0.295524224714752870173893L, 0.269266719309996355091227L, 0.219086362515982043995535L,
                              0.149451349150580593145863L, 0.066671344308688137593569L};
  Real sum = 0;
  for (int i = 0; i < panels; ++i) {
    const Real half = (to - from) / panels / 2, centre = from + (2 * i + 1) * half;
    for (std::size_t k = 0; k < 5; ++k) sum += half * weights[k] * (f(centre - half * nodes[k]) + f(centre + half * nodes[k]));
  }
  return sum;
}

TEST_CASE("the integral of every function is the one that quadrature finds") {
  // On [0.125, 1.125], where all are smooth: 64 panels of ten points leave (1/64)^20.
  struct Smooth {
    const char* text;
    Real (*f)(Real);
  };
  const Smooth functions[] = {
      {"tan(t/1 s)", [](Real t) { return std::tan(t); }},
      {"asin(t/2 s)/1 rad", [](Real t) { return std::asin(t / 2); }},
      {"acos((t/1 s)^2/2)/1 rad", [](Real t) { return std::acos(t * t / 2); }},
      {"atan(3*t/1 s)/1 rad", [](Real t) { return std::atan(3 * t); }},
      {"atan2(t/1 s - 3, (t/1 s)^2 - 1)/1 rad", [](Real t) { return std::atan2(t - 3, t * t - 1); }},
      {"sinh(2*t/1 s) * cosh(t/1 s)", [](Real t) { return std::sinh(2 * t) * std::cosh(t); }},
      {"tanh(sin(5*t/1 s))", [](Real t) { return std::tanh(std::sin(5 * t)); }},
      {"sqrt(1 + t/1 s) * log(t/1 s)", [](Real t) { return std::sqrt(1 + t) * std::log(t); }},
      {"(t/1 s)^2.5 + (t/1 s)^-3 + (1 + t/1 s)^7", [](Real t) { return std::pow(t, 2.5L) + std::pow(t, -3.0L) + std::pow(1 + t, 7.0L); }},
      {"exp(-(t/1 s)^2) / (2 + cos(3*t/1 s))", [](Real t) { return std::exp(-t * t) / (2 + std::cos(3 * t)); }},
      {"step5(t, 0 s, 2 s)", [](Real t) { return t * t * t / 8 * (10 + t / 2 * (3 * t - 15)); }},
      {"abs(-3 - t/1 s) * min(t/1 s, 2) + max(t/1 s, -1)", [](Real t) { return (3 + t) * t + t; }},
  };
  for (const Smooth& s : functions) {
    CAPTURE(s.text);
    const IntegralEnclosure f(Expression::parse(s.text, Time::allowed), 0, {0.125, 0.5, 1.125}, 1);
    const Bounds b = f.over(Bounds::exactly(1.125)).value;
    const Real known = by_gauss(s.f, 0.125L, 1.125L, 64), slack = 1e-17L * std::max<Real>(1, std::abs(known));
    CAPTURE(double(known), b.low, b.high);
    CHECK(Real(b.low) <= known + slack);
    CHECK(known - slack <= Real(b.high));
    CHECK(b.width() < 1e-13 * std::max(1.0, double(std::abs(known))));
  }
}

TEST_CASE("bounds of an integral that are too small are found out") {
  std::mt19937 generator(5);
  const Known& k = all[4];
  const Over over = bounds_of(k);
  // The rule of a panel that leaves out its remainder, say, is a little off.
  const Over off = [&](Bounds span) {
    Jet<Bounds> x = over(span);
    const double by = 1e-6 * span.middle();
    x.value = {x.value.low + by, x.value.high + by};
    return x;
  };
  const Over half = [&](Bounds span) {
    Jet<Bounds> x = over(span);
    x.value = {x.value.middle(), x.value.high};
    return x;
  };
  CHECK(escaped(over, k.at, 0, k.end, 100, generator).instants == 0);
  CHECK(escaped(off, k.at, 0, k.end, 100, generator).instants > 0);
  CHECK(escaped(half, k.at, 0, k.end, 100, generator).instants > 0);
}

TEST_CASE("the bounds of an integral shrink to what it does with the square of the span") {
  const Known& k = all[4];
  const Over over = bounds_of(k);
  for (const double t : {0.5, 2.25, 6.0})
    for (const double length : {0.01, 0.001}) {
      CAPTURE(t, length);
      const Real does = std::abs(k.at(t + length).value - k.at(t).value);                // it rises or falls there
      CHECK(double(over({t, t + length}).value.width() - does) < 20 * length * length);  // its second derivative is 10 at most
    }
}

TEST_CASE("an integral begins where it should, and nothing is known beyond its times") {
  const auto f = integral(all[0], 3);
  CHECK(f->over({0, 0}).value == Bounds{3, 3});
  CHECK_FALSE(f->over({-1, 1}).value.bounded());
  CHECK_FALSE(f->over({9, 10.5}).value.bounded());
}

TEST_CASE("an integral through a place without bounds ends in time, and is not known beyond") {
  for (const char* rate : {"1/abs(t/1 s - 1)", "tan(t/1 s)", "abs(t/1 s - 1.1)/(t/1 s - 1.1)"}) {
    CAPTURE(rate);
    const IntegralEnclosure f(Expression::parse(rate, Time::allowed), 0, {0, 0.5, 1, 1.2, 2}, 1);
    CHECK(f.over({0.25, 0.5}).value.bounded());
    CHECK_FALSE(f.over({0.25, 2}).value.bounded());
    CHECK_FALSE(f.over({1.9, 2}).value.bounded());
  }
  const IntegralEnclosure wild(Expression::parse("sin(1 s/t)", Time::allowed), 0, {0, 1}, 1);
  CHECK_FALSE(wild.over({0, 1}).value.bounded());
  const IntegralEnclosure unknown(Expression::parse("sqrt(-1 - t/1 s)", Time::allowed), 0, {0, 1}, NAN);
  CHECK_FALSE(unknown.over({0, 1}).value.bounded());
}
