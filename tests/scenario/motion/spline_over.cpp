// What a curve through points can be over a span of time, against its polynomials in extended precision.
#include <catch2/catch.hpp>
#include <chrono>
#include <core/scenario/motion/spline.hpp>
#include <tests/scenario/enclosed.hpp>
#include <thread>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace enclosed;

namespace {

struct KnotsOver {
  std::vector<double> times, values;
};
KnotsOver random_knots(std::mt19937& generator, std::size_t count) {
  std::uniform_real_distribution<double> digits(-2, 1), value(-1, 1);
  KnotsOver p;
  double t = -3;
  for (std::size_t i = 0; i < count; ++i, t += std::pow(10, digits(generator))) {
    p.times.push_back(t);
    p.values.push_back(value(generator));
  }
  return p;
}
std::size_t piece(const KnotsOver& p, Real t) {
  std::size_t i = 0;
  while (i + 2 < p.times.size() && t >= Real(p.times[i + 1])) ++i;
  return i;
}

// Its second derivatives at the points are what the curve says there: they are stored, and given back as they are, but for the last.
At cubic(const KnotsOver& p, const CubicSpline& curve) {
  std::vector<double> bends;
  for (const double t : p.times) bends.push_back(curve.at(t).acceleration);
  return [p, bends](Real t) -> Jet<Real> {
    const std::size_t i = piece(p, t);
    if (i + 2 == p.times.size()) return {NAN, NAN, NAN};
    const Real h = Real(p.times[i + 1]) - p.times[i], s = t - p.times[i], m = bends[i], n = bends[i + 1];
    const Real slope = (Real(p.values[i + 1]) - p.values[i]) / h - h * (2 * m + n) / 6, jerk = (n - m) / h;
    return {p.values[i] + s * (slope + s * (m / 2 + s * jerk / 6)), slope + s * (m + s * jerk / 2), m + s * jerk};
  };
}
At quintic(const KnotsOver& p) {
  return [p](Real t) -> Jet<Real> {
    const std::size_t i = piece(p, t);
    const Real h = Real(p.times[i + 1]) - p.times[i], step = Real(p.values[i + 1]) - p.values[i], u = (t - p.times[i]) / h, v = 1 - u;
    if (u < 0 || u > 1) return {u < 0 ? p.values.front() : p.values.back(), 0.0L, 0.0L};
    return {p.values[i] + step * (u * u * u * (10 + u * (6 * u - 15))), step / h * 30 * u * u * v * v,
            step / (h * h) * 60 * u * v * (v - u)};
  };
}
template <class Curve>
Over bounds_of(const Curve& curve) {
  return [&curve](Bounds span) { return curve.over(span); };
}

// How much wider the bounds are than what the curve does, as a share of that: at its points, and many instants of every piece.
double excess(const Bounds& b, const KnotsOver& p, const Bounds& span, const std::function<Real(Real)>& f) {
  constexpr int instants = 500;
  Real least = INFINITY, most = -INFINITY;
  for (std::size_t i = 0; i + 1 < p.times.size(); ++i) {
    const Real from = std::max(p.times[i], span.low), to = std::min(p.times[i + 1], span.high);
    for (int k = 0; from < to && k <= instants; ++k) {
      const Real x = f(from + (to - from) * k / instants);
      least = std::min(least, x), most = std::max(most, x);
    }
  }
  return double((Real(b.high) - Real(b.low)) / (most - least) - 1);
}

}  // namespace

TEST_CASE("at every instant a curve through points is within its bounds over the span") {
  constexpr unsigned seed = 6;
  std::mt19937 generator(seed);
  for (const std::size_t count : {2u, 3u, 4u, 5u, 9u, 40u, 300u})
    for (int repeat = 0; repeat < 5; ++repeat) {
      const KnotsOver p = random_knots(generator, count);
      CAPTURE(seed, count, repeat);
      const double begin = p.times.front(), end = p.times.back();
      for (const Ends ends : {Ends::at_rest, Ends::not_a_knot}) {
        const CubicSpline curve(p.times, p.values, ends);
        const Escaped out = escaped(bounds_of(curve), cubic(p, curve), begin, end, 60, generator);
        INFO(out.first);
        CHECK(out.instants == 0);
        CHECK(out.unbounded == 0);
      }
      const QuinticSteps curve(p.times, p.values);
      const Escaped out = escaped(bounds_of(curve), quintic(p), begin - 1, end + 1, 60, generator);
      INFO(out.first);
      CHECK(out.instants == 0);
      CHECK(out.unbounded == 0);
    }
}

TEST_CASE("the bounds of a curve through points are what it does, but for rounding") {
  constexpr unsigned seed = 7;
  std::mt19937 generator(seed);
  const KnotsOver p = random_knots(generator, 40);
  const CubicSpline smooth(p.times, p.values, Ends::at_rest);
  const QuinticSteps steps(p.times, p.values);
  const At smooth_at = cubic(p, smooth), steps_at = quintic(p);
  for (int i = 0; i < 40; ++i) {
    Bounds span = random_span(generator, p.times.front(), p.times[38]);
    if (span.width() < 1e-3) continue;
    CAPTURE(seed, i, span.low, span.high);
    for (const bool cubic : {true, false}) {
      const Jet<Bounds> b = cubic ? smooth.over(span) : steps.over(span);
      const At& at = cubic ? smooth_at : steps_at;
      // The nearest of 500 instants is at most a thousandth of a piece beside an extreme. In this share u of a piece a quintic leaves its
      // greatest acceleration, 5.8, by 173 u^2 = 1.7e-4, and its greatest rate, 1.9, by 30 u^2.
      constexpr double share = 1e-4;
      CHECK(excess(b.value, p, span, [&](Real t) { return at(t).value; }) < share);
      CHECK(excess(b.rate, p, span, [&](Real t) { return at(t).rate; }) < share);
      CHECK(excess(b.acceleration, p, span, [&](Real t) { return at(t).acceleration; }) < share);
    }
  }
}

TEST_CASE("bounds of a curve that forget a piece are found out") {
  std::mt19937 generator(8);
  KnotsOver p = random_knots(generator, 30);
  const std::size_t forgotten = 13;  // in which the rate is greatest
  p.values[forgotten] = -50, p.values[forgotten + 1] = 50;
  const CubicSpline curve(p.times, p.values, Ends::at_rest);
  const Over forgetful = [&](Bounds span) {
    const double a = p.times[forgotten], b = p.times[forgotten + 1];
    if (!(span.low < a && span.high > b)) return curve.over(span);
    const Jet<Bounds> before = curve.over({span.low, a}), after = curve.over({b, span.high});
    return Jet<Bounds>(hull(before.value, after.value), hull(before.rate, after.rate), hull(before.acceleration, after.acceleration));
  };
  CHECK(escaped(bounds_of(curve), cubic(p, curve), p.times.front(), p.times.back(), 300, generator).instants == 0);
  CHECK(escaped(forgetful, cubic(p, curve), p.times.front(), p.times.back(), 300, generator).instants > 0);
}

TEST_CASE("a point of a curve has the bounds of both its pieces") {
  const CubicSpline curve({0, 1, 3}, {0, 1, 0}, Ends::at_rest);
  const Jet<Bounds> x = curve.over(Bounds::exactly(1));
  CHECK(x.value.has(1));
  CHECK(x.value.width() < 1e-15);
  CHECK(x.rate.has(curve.at(1).rate));
  CHECK(x.rate.width() < 1e-14);
  // Quintic steps rest there; the bounds are those of both sides.
  const Jet<Bounds> rest = QuinticSteps({0, 1, 3}, {0, 1, 0}).over({0.9, 1.1});
  CHECK(rest.acceleration.low < 0);
  CHECK(rest.rate.low < 0);
  CHECK(rest.rate.high > 0);
  CHECK(rest.value.high == Approx(1).epsilon(1e-15));
}

TEST_CASE("of a hundred thousand points any span is quick, and the same in all threads") {
  std::mt19937 generator(9);
  const KnotsOver p = random_knots(generator, 100000);
  const CubicSpline curve(p.times, p.values, Ends::not_a_knot);
  const double begin = p.times.front(), end = p.times.back();
  std::vector<Bounds> spans;
  for (int i = 0; i < 2000; ++i) spans.push_back(random_span(generator, begin, end));
  const auto run = [&](std::vector<Bounds>& out) {
    for (const Bounds& span : spans) out.push_back(curve.over(span).value);
  };
  std::vector<Bounds> alone, first, second;
  std::thread other([&] { run(first); });
  run(second);
  other.join();
  const auto start = std::chrono::steady_clock::now();
  run(alone);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CHECK(first == alone);
  CHECK(second == alone);
  CHECK(seconds < 1);  // half a millisecond each: a hundred times what they take, a hundredth of looking at all pieces
  CHECK(curve.over({begin, end}).value.high >= *std::max_element(p.values.begin(), p.values.end()));
}
