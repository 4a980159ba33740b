// What the functions of the mathematical library make of the ends of an interval.
//
// Every function is monotone between its extremes: its range over an interval is that of the ends, and of the extremes within. The library
// rounds as it likes, but errs by no more than `ulps` units in the last place, and so much the ends are moved outward. Rounding must go
// upward (rounding.hpp).
#pragma once

#include <core/program/intervals/interval_waves.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::program {

namespace ends {

// Bounds on the error of glibc 2.36 in double precision while rounding goes upward, in units in the last place. Its manual ("Known Maximum
// Errors in Math Functions", x86_64) knows of 1 for tangent, the arcs, exp, log and pow, of 2 for the hyperbolic ones; its
// tests, of all rounding modes, with rounding upward of 2 for asin and of 3 for the hyperbolic ones (sysdeps/x86_64/fpu/libm-test-ulps).
// tests/judges/intervals searches for worse.
constexpr double tangent_ulps = 2, arc_ulps = 3, exponential_ulps = 2, hyperbolic_ulps = 4;

// An end that the library computed, moved outward. The unit in the last place of v is no more than 2^-52 |v|, or, of numbers below 2^-1022,
// less than 2^-1022. `exact`: v is what it should be.
inline double outward(double v, double ulps, bool exact = false) {
  constexpr double unit = std::numeric_limits<double>::epsilon(), least = std::numeric_limits<double>::min();
  return exact ? v : v + (std::abs(v) * (ulps * unit) + ulps * least);
}

// f rises; it is zero at zero, and there exact.
template <class F>
Ends rising(const Ends& x, double ulps, F&& f) {
  return {outward(-f(x.low()), ulps, x.negative_low == 0), outward(f(x.high), ulps, x.high == 0)};
}

inline Ends tan(const Ends& x) {
  if (!(magnitude(x) <= largest_angle) || multiples_of_pi(x, 0.5).any()) return Ends::unbounded();
  return rising(x, tangent_ulps, [](double a) { return std::tan(a); });
}

inline bool beyond_one(const Ends& x) { return !(x.negative_low <= 1 && x.high <= 1); }

inline Ends asin(const Ends& x) {
  if (beyond_one(x)) return Ends::unbounded();
  return rising(x, arc_ulps, [](double a) { return std::asin(a); });
}
inline Ends acos(const Ends& x) {  // falls
  if (beyond_one(x)) return Ends::unbounded();
  return {std::min(0.0, outward(-std::acos(x.high), arc_ulps)), outward(std::acos(x.low()), arc_ulps, x.low() == 1)};
}
inline Ends atan(const Ends& x) {
  if (!x.bounded()) return Ends::unbounded();
  return rising(x, arc_ulps, [](double a) { return std::atan(a); });
}

// The angle of (x, y) rises with y where x > 0 and falls where x < 0; it falls with x where y > 0 and rises where y < 0. So in a box that
// neither holds the origin nor meets the cut, x <= 0 on y = 0, it is least and greatest at a corner, which the signs tell.
inline Ends atan2(const Ends& y, const Ends& x) {
  if (!y.bounded() || !x.bounded()) return Ends::unbounded();
  const double x_low = x.low(), y_low = y.low();
  if (y_low <= 0 && y.high >= 0 && x_low <= 0) {
    if (x.high >= 0) return Ends::unbounded();
    const double pi = outward(std::numbers::pi, 1);
    return {pi, pi};
  }
  const double x_least = y_low > 0 ? x.high : x_low, y_least = x_least > 0 ? y_low : y.high;
  const double x_most = y.high < 0 ? x.high : x_low, y_most = x_most > 0 ? y.high : y_low;
  return {outward(-std::atan2(y_least, x_least), arc_ulps, y_least == 0), outward(std::atan2(y_most, x_most), arc_ulps, y_most == 0)};
}

// Where the library's result overflows there is no bound; the low end then is not asked for either.
inline Ends positive(double low, double high, double ulps) {
  if (!(high < std::numeric_limits<double>::infinity())) return Ends::unbounded();
  return {std::min(0.0, outward(-low, ulps)), outward(high, ulps)};
}

inline Ends exp(const Ends& x) {
  if (!x.bounded()) return Ends::unbounded();
  if (x.negative_low == 0 && x.high == 0) return {-1, 1};
  return positive(std::exp(x.low()), std::exp(x.high), exponential_ulps);
}
inline Ends log(const Ends& x) {
  if (!x.bounded() || !(x.low() > 0)) return Ends::unbounded();
  return {outward(-std::log(x.low()), exponential_ulps, x.low() == 1), outward(std::log(x.high), exponential_ulps, x.high == 1)};
}

inline Ends sinh(const Ends& x) {
  if (!x.bounded()) return Ends::unbounded();
  const double low = std::sinh(x.low()), high = std::sinh(x.high);
  if (!std::isfinite(low) || !std::isfinite(high)) return Ends::unbounded();
  return {outward(-low, hyperbolic_ulps, low == 0), outward(high, hyperbolic_ulps, high == 0)};
}
inline Ends cosh(const Ends& x) {
  if (!x.bounded()) return Ends::unbounded();
  const Ends r = positive(std::cosh(mignitude(x)), std::cosh(magnitude(x)), hyperbolic_ulps);
  return r.bounded() ? Ends{std::min(-1.0, r.negative_low), r.high} : r;
}
inline Ends tanh(const Ends& x) {
  if (!x.bounded()) return Ends::unbounded();
  const Ends r = rising(x, hyperbolic_ulps, [](double a) { return std::tanh(a); });
  return {std::min(1.0, r.negative_low), std::min(1.0, r.high)};
}

// x^n for constant n: of whole n for every x, of others for x >= 0; of n < 0 for no interval with zero in it. |x|^n rises with |x| for n >
// 0.
inline Ends pow(const Ends& x, double n) {
  if (!x.bounded() || !std::isfinite(n)) return Ends::unbounded();
  if (n == 0) return {-1, 1};
  if (n == 1) return x;
  const bool whole = std::floor(n) == n, odd = whole && std::floor(n / 2) * 2 != n;
  const double low = x.low(), least = mignitude(x), most = magnitude(x);
  if ((!whole && low < 0) || (n < 0 && !(least > 0))) return Ends::unbounded();
  const auto power = [n](double a) { return std::pow(a, n); };
  if (!odd) return n > 0 ? positive(power(least), power(most), exponential_ulps) : positive(power(most), power(least), exponential_ulps);
  if (low >= 0)
    return n > 0 ? positive(power(low), power(x.high), exponential_ulps) : positive(power(x.high), power(low), exponential_ulps);
  if (n > 0) {  // rises through zero, or up to it
    const double at_low = power(low), at_high = power(x.high);
    if (!std::isfinite(at_low) || !std::isfinite(at_high)) return Ends::unbounded();
    return {outward(-at_low, exponential_ulps), x.high == 0 ? 0.0 : outward(at_high, exponential_ulps)};
  }
  const Ends r = pow({x.high, x.negative_low}, n);  // x < 0: (-x)^n = -x^n
  return {r.high, r.negative_low};
}

}  // namespace ends
}  // namespace pmreport::program
