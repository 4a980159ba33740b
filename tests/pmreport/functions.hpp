// Every function that a scalar of the geometry offers, by name, with the range in which it is tried: away from edges where a derivative is
// infinite, and from kinks, where there is none.
#pragma once

#include <pmreport/scalar.hpp>
#include <random>

namespace functions {

using namespace pmreport;

template <class Visit>
void each_of_one(Visit&& visit) {
  visit("-x", -2.0, 2.0, [](const auto& x) { return -x; });
  visit("x + 0.7", -2.0, 2.0, [](const auto& x) { return x + 0.7; });
  visit("0.7 + x", -2.0, 2.0, [](const auto& x) { return 0.7 + x; });
  visit("x - 0.7", -2.0, 2.0, [](const auto& x) { return x - 0.7; });
  visit("0.7 - x", -2.0, 2.0, [](const auto& x) { return 0.7 - x; });
  visit("x * 0.7", -2.0, 2.0, [](const auto& x) { return x * 0.7; });
  visit("0.7 * x", -2.0, 2.0, [](const auto& x) { return 0.7 * x; });
  visit("x / 0.7", -2.0, 2.0, [](const auto& x) { return x / 0.7; });
  visit("0.7 / x", 0.5, 2.0, [](const auto& x) { return 0.7 / x; });
  visit("0.7 / x, x < 0", -2.0, -0.5, [](const auto& x) { return 0.7 / x; });
  visit("square", -2.0, 2.0, [](const auto& x) { return square(x); });
  visit("sqrt", 0.3, 4.0, [](const auto& x) { return sqrt(x); });
  visit("sin", -4.0, 4.0, [](const auto& x) { return sin(x); });
  visit("cos", -4.0, 4.0, [](const auto& x) { return cos(x); });
  visit("tan", -1.0, 1.0, [](const auto& x) { return tan(x); });
  visit("asin", -0.7, 0.7, [](const auto& x) { return asin(x); });
  visit("acos", -0.7, 0.7, [](const auto& x) { return acos(x); });
  visit("abs, x > 0", 0.2, 2.0, [](const auto& x) { return abs(x); });
  visit("abs, x < 0", -2.0, -0.2, [](const auto& x) { return abs(x); });
}

// Both arguments come from the range.
template <class Visit>
void each_of_two(Visit&& visit) {
  visit("x + y", -2.0, 2.0, [](const auto& x, const auto& y) { return x + y; });
  visit("x - y", -2.0, 2.0, [](const auto& x, const auto& y) { return x - y; });
  visit("x * y", -2.0, 2.0, [](const auto& x, const auto& y) { return x * y; });
  visit("x / y", 0.5, 2.0, [](const auto& x, const auto& y) { return x / y; });
  visit("x / -y", 0.5, 2.0, [](const auto& x, const auto& y) { return x / -y; });
  visit("x += y", -2.0, 2.0, [](auto x, const auto& y) { return x += y; });
  visit("x -= y", -2.0, 2.0, [](auto x, const auto& y) { return x -= y; });
  visit("x *= y", -2.0, 2.0, [](auto x, const auto& y) { return x *= y; });
  visit("x /= y", 0.5, 2.0, [](auto x, const auto& y) { return x /= y; });
  visit("hypot", 0.3, 2.0, [](const auto& x, const auto& y) { return hypot(x, y); });
  visit("atan2, first quadrant", 0.3, 2.0, [](const auto& x, const auto& y) { return atan2(x, y); });
  visit("atan2, second quadrant", 0.3, 2.0, [](const auto& x, const auto& y) { return atan2(x, -y); });
  visit("atan2, third quadrant", 0.3, 2.0, [](const auto& x, const auto& y) { return atan2(-x, -y); });
  visit("atan2, fourth quadrant", 0.3, 2.0, [](const auto& x, const auto& y) { return atan2(-x, y); });
  visit("smaller", 0.3, 2.0, [](const auto& x, const auto& y) { return smaller(x, y + 4.0) * smaller(x + 4.0, y); });
  visit("larger", 0.3, 2.0, [](const auto& x, const auto& y) { return larger(x, y + 4.0) * larger(x + 4.0, y); });
  visit("choose", 0.3, 2.0, [](const auto& x, const auto& y) { return choose(x < 9.0, x, y) * choose(x > 9.0, x, y); });
}

// A number from min to max; the same on every platform for the same seed, as std::uniform_real_distribution is not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double within(double min, double max) { return min + (max - min) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace functions
