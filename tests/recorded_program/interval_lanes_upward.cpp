// Each lane has, to the last bit, the interval that it would have alone.
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/program/intervals/interval_lanes.hpp>
#include <core/program/intervals/rounding.hpp>
#include <cstdint>
#include <random>

using namespace pmreport;
using namespace pmreport::program;

namespace {

using Numbers = std::array<double, Lanes::width>;
using Intervals = std::array<Interval, Lanes::width>;

// Ends of all sizes, with what is special strewn in.
Interval any_interval(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto number = [&] {
    const double special[] = {0.0, -0.0, 1.0, -1.0, 0x1p-1074, 1e300, 3.5};
    return random() % 4 == 0 ? special[random() % std::size(special)] : share(random) * std::exp2(8 * share(random));
  };
  const double a = number(), b = random() % 4 == 0 ? a : number();
  if (random() % 16 == 0) return Interval::of_ends(infinity, a);
  return {std::min(a, b), std::max(a, b)};
}

IntervalLanes together(const Intervals& x) {
  Numbers n, h;
  for (std::size_t i = 0; i < x.size(); ++i) n[i] = x[i].negative_low, h[i] = x[i].high;
  return IntervalLanes::of_ends(Lanes::load(n.data()), Lanes::load(h.data()));
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

template <class Visit>
void each_function(Visit&& visit) {
  visit("x + y", [](const auto& x, const auto& y) { return x + y; });
  visit("x - y", [](const auto& x, const auto& y) { return x - y; });
  visit("x y", [](const auto& x, const auto& y) { return x * y; });
  visit("x / y", [](const auto& x, const auto& y) { return x / y; });
  visit("-x", [](const auto& x, const auto&) { return -x; });
  visit("x + 0.7", [](const auto& x, const auto&) { return x + 0.7; });
  visit("0.7 - x", [](const auto& x, const auto&) { return 0.7 - x; });
  visit("-0.7 x", [](const auto& x, const auto&) { return x * -0.7; });
  visit("0 x", [](const auto& x, const auto&) { return 0.0 * x; });
  visit("x / 0.7", [](const auto& x, const auto&) { return x / 0.7; });
  visit("0.7 / x", [](const auto& x, const auto&) { return 0.7 / x; });
  visit("square", [](const auto& x, const auto&) { return square(x); });
  visit("sqrt", [](const auto& x, const auto&) { return sqrt(abs(x)) + sqrt(x); });
  visit("sin", [](const auto& x, const auto&) { return sin(x); });
  visit("cos", [](const auto& x, const auto&) { return cos(x); });
  visit("tan", [](const auto& x, const auto&) { return tan(x); });
  visit("asin", [](const auto& x, const auto&) { return asin(x); });
  visit("acos", [](const auto& x, const auto&) { return acos(x); });
  visit("atan", [](const auto& x, const auto&) { return atan(x); });
  visit("atan2", [](const auto& x, const auto& y) { return atan2(x, y); });
  visit("hypot", [](const auto& x, const auto& y) { return hypot(x, y); });
  visit("abs", [](const auto& x, const auto&) { return abs(x); });
  visit("exp", [](const auto& x, const auto&) { return exp(x); });
  visit("log", [](const auto& x, const auto&) { return log(x); });
  visit("sinh", [](const auto& x, const auto&) { return sinh(x); });
  visit("cosh", [](const auto& x, const auto&) { return cosh(x); });
  visit("tanh", [](const auto& x, const auto&) { return tanh(x); });
  visit("x^3", [](const auto& x, const auto&) { return pow(x, 3); });
  visit("x^-2", [](const auto& x, const auto&) { return pow(x, -2); });
  visit("smaller", [](const auto& x, const auto& y) { return smaller(x, y); });
  visit("larger", [](const auto& x, const auto& y) { return larger(x, y); });
  visit("hull", [](const auto& x, const auto& y) { return hull(x, y); });
  visit("common", [](const auto& x, const auto& y) { return common(x, y); });
  visit("choose", [](const auto& x, const auto& y) { return choose(x < y && !(y > 2.0 * x) || x > 1.0, x, y); });
}

}  // namespace

TEST_CASE("intervals in lanes are the intervals of each lane, bit for bit") {
  std::mt19937_64 random(3);
  each_function([&](const char* name, auto f) {
    CAPTURE(name);
    for (int i = 0; i < 2000; ++i) {
      Intervals x, y;
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = any_interval(random), y[k] = any_interval(random);
      const IntervalLanes all = round_upward([&] { return f(together(x), together(y)); });
      Numbers n, h;
      all.negative_low.store(n.data());
      all.high.store(h.data());
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Interval alone = round_upward([&] { return f(x[k], y[k]); });
        if (!same_bits(n[k], alone.negative_low) || !same_bits(h[k], alone.high)) {
          CAPTURE(i, k, x[k].low(), x[k].high, y[k].low(), y[k].high);
          CHECK(n[k] == alone.negative_low);
          CHECK(h[k] == alone.high);
          FAIL("other bits");
        }
      }
    }
  });
}
