// The ends of an interval, and sine and cosine of it.
//
// Sine and cosine are our own: the library's take ten times as long, since they change the rounding mode and change it back; and they have
// other digits on other processors. Rounding must go upward (rounding.hpp), for the bounds of errors below too.
#pragma once

#if !defined(__ROUNDING_MATH__) && !defined(PMREPORT_ROUNDING_MATH)
#error "Intervals need -frounding-math, which files named *_upward.cpp are compiled with: see core/program/intervals/rounding.hpp."
#endif

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::program {

// Low and high end, the low one with its sign turned: rounded upward, both move outward. Neither is minus infinity. One that is infinite:
// nothing is known of the number, not even that there is one.
struct Ends {
  double negative_low = 0, high = 0;

  double low() const { return -negative_low; }
  bool bounded() const { return negative_low < std::numeric_limits<double>::infinity() && high < std::numeric_limits<double>::infinity(); }
  static Ends unbounded() { return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}; }
};

namespace ends {

// Of the two ends: the largest and the smallest |x|.
inline double magnitude(const Ends& x) { return std::max(x.negative_low, x.high); }
inline double mignitude(const Ends& x) { return std::max(0.0, -std::min(x.negative_low, x.high)); }

// The whole number not below x, |x| < 2^51: beyond 2^52 there are no others.
inline double ceiling(double x) {
  constexpr double shift = 0x1.8p52;
  return (x + shift) - shift;
}

// Beyond, arguments are taken for any.
constexpr double largest_angle = 0x1p20;

// The whole numbers from `first` to `last` are those k for which (k + shift) pi lies in x, or so near that rounding leaves it open: within
// 2^-28. There sine and cosine differ from one by less than 2^-57, so that nothing is lost by taking the extreme for one within.
struct Multiples {
  double first, last;
  bool any() const { return first <= last; }
  bool both_parities() const { return first < last; }
  bool first_is_even() const { return ceiling(0.5 * first) == 0.5 * first; }
  bool even() const { return both_parities() || (any() && first_is_even()); }
  bool odd() const { return both_parities() || (any() && !first_is_even()); }
};
inline Multiples multiples_of_pi(const Ends& x, double shift) {
  constexpr double slack = 0x1p-50;  // several times what 1 / pi, its product and the difference are rounded by, together
  const double low = x.low() * std::numbers::inv_pi - shift, high = x.high * std::numbers::inv_pi - shift;
  return {ceiling(low - slack * (1 + std::abs(low))), -ceiling(-(high + slack * (1 + std::abs(high))))};
}

// A value that is wrong by no more than `error`.
struct Approximation {
  double value, error;
};

// sin(x + quarters pi / 2), |x| <= 2^20, for `quarters` 0 and 1: sine and cosine.
//
// Reduction. k is the whole number nearest to x / (pi / 2), nearly, below 2^20; pi / 2 = a + b + c, a and b of 30 bits each, to 2^-29 and
// 2^-59, c below 2^-60 and wrong by less than 2^-114. Then k a and k b are exact, and so is x - k a: less than one, and a multiple of
// 2^-53, as from |x| = 0.7 on x is (below, k = 0). r = x - k a - k b is rounded, but what is lost is exact: where k b is more than half of
// x - k a, nothing, both being multiples of 2^-60 below 2^-8; else x - k a - r is exact (Sterbenz), and what is left a multiple of 2^-60
// below 2^-53. So x = k pi / 2 + r + s with |r| < 0.79, |s| < 2^-40, and an error below 2^-91.
//
// Taylor series, cut off where for |r| < 0.79 the next term is below 2^-63 |r| of sine, 2^-58 of cosine; and
// sin(r + s) = sin r + s cos r, cos(r + s) = cos r - s sin r to 2^-81 r.
//
// Rounding. Each operation errs by less than e = 2^-52 of its result. Sine: r z S, with S near -1/6, is less than 0.103 |r| and wrong by
// less than 5 e of it; the additions by e each: 1.7 e of the whole. Cosine: z / 2 < 0.32 is wrong by e of it, the rest of the series, less
// than 0.017, by 6 e, each of three additions, to results below 1, by e / 2: 2 e, which is less than 2.8 e of the whole, that being more
// than 0.7. What comes from s, some e |s|, is nothing beside these unless r is small, and below 2^-8 s is k c alone, less than 2^-60 k: the
// product, that with the cosine and the addition, of which the whole may be what they leave, err by less than 2^-110 k together.
constexpr double wave_units = 3;
inline Approximation wave_at(double x, double quarters, double units) {
  const double k = ceiling(x * 0x1.45f306dc9c883p-1 - 0.5);
  const double x_a = x - k * 0x1.921fb54p+0, k_b = k * 0x1.10b46118p-30;
  const double r = x_a - k_b, s = ((x_a - r) - k_b) - k * 0x1.313198a2e0370p-61;
  const double z = r * r;
  const double sine_series =
      z * (-0x1.5555555555555p-3 +
           z * (0x1.1111111111111p-7 +
                z * (-0x1.a01a01a01a01ap-13 +
                     z * (0x1.71de3a556c734p-19 +
                          z * (-0x1.ae64567f544e4p-26 +
                               z * (0x1.6124613a86d09p-33 + z * (-0x1.ae7f3e733b81fp-41 + z * 0x1.952c77030ad4ap-49)))))));
  const double cosine_series =
      z * z *
      (0x1.5555555555555p-5 +
       z * (-0x1.6c16c16c16c17p-10 +
            z * (0x1.a01a01a01a01ap-16 +
                 z * (-0x1.27e4fb7789f5cp-22 + z * (0x1.1eed8eff8d898p-29 + z * (-0x1.93974a8c07c9dp-37 + z * 0x1.ae7f3e733b81fp-45))))));
  const double sine = r + r * sine_series, cosine = (1 - 0.5 * z) + cosine_series;
  const double turned_sine = r + (r * sine_series + s * cosine), turned_cosine = cosine - s * sine;

  const double all_quarters = k + quarters, quarter = all_quarters - 4 * ceiling(0.25 * all_quarters - 0.75);  // 0 to 3
  const double value = quarter == 1 || quarter == 3 ? turned_cosine : turned_sine;
  return {quarter >= 2 ? -value : value, units * (0x1p-52 * std::abs(value) + 0x1p-111 * std::abs(k))};
}

// cos(x), with its extremes at k pi, or sin(x), with those at (k + 1/2) pi; greatest where k is even. Without a branch, for vectors.
inline Ends wave(const Ends& x, double quarters, double units) {
  const double size = magnitude(x);
  const Multiples extremes = multiples_of_pi(x, quarters == 0 ? 0.5 : 0.0);
  const Approximation at_low = wave_at(x.low(), quarters, units), at_high = wave_at(x.high, quarters, units);
  const double n = std::max(-at_low.value + at_low.error, -at_high.value + at_high.error);
  const double h = std::max(at_low.value + at_low.error, at_high.value + at_high.error);
  const double at_zero = size == 0 && quarters == 1 ? -1 : 1;  // of a cosine that is one
  const bool far = size > largest_angle, unbounded = !(size < std::numeric_limits<double>::infinity());
  const double infinite = std::numeric_limits<double>::infinity();
  return {unbounded               ? infinite
          : far || extremes.odd() ? 1.0
                                  : std::min(at_zero, n),
          unbounded                ? infinite
          : far || extremes.even() ? 1.0
                                   : std::min(1.0, h)};
}

inline Ends sin(const Ends& x, double units = wave_units) { return wave(x, 0, units); }
inline Ends cos(const Ends& x, double units = wave_units) { return wave(x, 1, units); }

}  // namespace ends
}  // namespace pmreport::program
