// An interval: what is known of a number, as a scalar of the geometry.
//
// Two finite ends say that the number has a value, at every point of the box that is looked at, and that it lies between them, both
// included. An infinite end says nothing at all, not even that there is such a number; and so says all that is computed from it: sine,
// product with zero and minimum included. Division by an interval with zero in it, the square root of one that reaches below zero and the
// like give such an interval. No NaN comes out. A constant that is not finite is taken for one of which nothing is known.
//
// Rounding must go upward wherever one is computed: rounding.hpp says how.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/program/intervals/interval_ends.hpp>
#include <pmreport/scalar.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace pmreport::program {

// Of S the operations + - *, /, <, sqrt and choose are used, and on each lane the functions of interval_ends.hpp. A double has one lane.
template <class S>
struct BasicInterval {
  S negative_low{}, high{};  // rounded upward, both ends move outward; neither is minus infinity

  // The answer of a comparison: certain for all numbers of the two intervals, or open where neither is.
  struct Mask {
    using Certain = decltype(std::declval<const S&>() < std::declval<const S&>());
    Certain yes, no;

    friend Mask operator&&(const Mask& a, const Mask& b) { return {a.yes && b.yes, a.no || b.no}; }
    friend Mask operator||(const Mask& a, const Mask& b) { return {a.yes || b.yes, a.no && b.no}; }
    friend Mask operator!(const Mask& a) { return {a.no, a.yes}; }
  };

  BasicInterval() = default;
  BasicInterval(double constant) : negative_low(-constant), high(constant) {  // implicit: constants stay readable
    if (!std::isfinite(constant)) *this = unbounded();
  }
  // Reversed, infinite or no numbers: nothing is known.
  BasicInterval(const S& low, const S& high_end) {
    const S infinity(infinite);
    *this = where(!(high_end < low) && -infinity < low && high_end < infinity, of_ends(-low, high_end));
  }
  explicit BasicInterval(const Bounds& b) requires std::is_same_v<S, double> : BasicInterval(b.low, b.high) {}

  static BasicInterval of_ends(const S& negative_low, const S& high) {
    BasicInterval r;
    r.negative_low = negative_low;
    r.high = high;
    return r;
  }
  static BasicInterval unbounded() { return of_ends(S(infinite), S(infinite)); }

  S low() const { return -negative_low; }
  typename Mask::Certain is_bounded() const { return magnitude() < S(infinite); }
  bool bounded() const requires std::is_same_v<S, double> { return is_bounded(); }
  Bounds bounds() const requires std::is_same_v<S, double> { return bounded() ? Bounds{low(), high} : Bounds{}; }
  bool contains(double x) const  // may it be x
      requires std::is_same_v<S, double> {
    return !bounded() || (low() <= x && x <= high);
  }
  S width() const { return negative_low + high; }
  S magnitude() const { return most(negative_low, high); }                                        // the largest |x|
  S mignitude() const { return most(S(0.0), -least(negative_low, high)); }                        // the least
  S middle() const { return where_else(is_bounded(), 0.5 * high - 0.5 * negative_low, S(0.0)); }  // inside

  BasicInterval operator-() const { return of_ends(high, negative_low); }
  BasicInterval& operator+=(const BasicInterval& o) { return *this = *this + o; }
  BasicInterval& operator-=(const BasicInterval& o) { return *this = *this - o; }
  BasicInterval& operator*=(const BasicInterval& o) { return *this = *this * o; }
  BasicInterval& operator/=(const BasicInterval& o) { return *this = *this / o; }

  friend BasicInterval operator+(const BasicInterval& a, const BasicInterval& b) {
    return of_ends(a.negative_low + b.negative_low, a.high + b.high);
  }
  friend BasicInterval operator-(const BasicInterval& a, const BasicInterval& b) {
    return of_ends(a.negative_low + b.high, a.high + b.negative_low);
  }
  // The greatest of the products of two ends, and of their opposites.
  friend BasicInterval operator*(const BasicInterval& a, const BasicInterval& b) {
    const S a_low = -a.negative_low, b_low = -b.negative_low, a_opposite = -a.high;
    const S n = most(most(a.negative_low * b_low, a.negative_low * b.high), most(a_opposite * b_low, a_opposite * b.high));
    const S h = most(most(a_low * b_low, a_low * b.high), most(a.high * b_low, a.high * b.high));
    return where(both_bounded(a, b), of_ends(n, h));
  }
  // Of a / b with b > 0 the high end is a's by that of b which leaves it greater; b < 0: (-a) / (-b).
  friend BasicInterval operator/(const BasicInterval& a, const BasicInterval& b) {
    const auto turned = b.high < S(0.0);
    const S n = where_else(turned, a.high, a.negative_low), h = where_else(turned, a.negative_low, a.high);
    const S least = where_else(turned, S(-b.high), S(-b.negative_low)), greatest = where_else(turned, b.negative_low, b.high);
    const BasicInterval r = of_ends(n / where_else(n < S(0.0), greatest, least), h / where_else(h < S(0.0), greatest, least));
    return where(both_bounded(a, b) && S(0.0) < least, r);
  }

  // Constants need no product of all ends.
  friend BasicInterval operator+(const BasicInterval& a, double c) {
    return std::isfinite(c) ? of_ends(a.negative_low - S(c), a.high + S(c)) : unbounded();
  }
  friend BasicInterval operator+(double c, const BasicInterval& a) { return a + c; }
  friend BasicInterval operator-(const BasicInterval& a, double c) { return a + -c; }
  friend BasicInterval operator-(double c, const BasicInterval& a) { return -a + c; }
  friend BasicInterval operator*(const BasicInterval& a, double c) {
    if (0 < c && c < infinite) return of_ends(a.negative_low * S(c), a.high * S(c));
    if (-infinite < c && c < 0) return of_ends(a.high * S(-c), a.negative_low * S(-c));
    return c == 0 ? where(a.is_bounded(), BasicInterval(0.0)) : unbounded();
  }
  friend BasicInterval operator*(double c, const BasicInterval& a) { return a * c; }
  friend BasicInterval operator/(const BasicInterval& a, double c) {
    if (c == 0 || !std::isfinite(c)) return unbounded();
    return c > 0 ? of_ends(a.negative_low / S(c), a.high / S(c)) : of_ends(a.high / S(-c), a.negative_low / S(-c));
  }
  friend BasicInterval operator/(double c, const BasicInterval& a) { return BasicInterval(c) / a; }

  friend Mask operator<(const BasicInterval& a, const BasicInterval& b) {
    const auto known = both_bounded(a, b);
    return {a.high < -b.negative_low && known, !(-a.negative_low < b.high) && known};
  }
  friend Mask operator>(const BasicInterval& a, const BasicInterval& b) { return b < a; }
  friend BasicInterval choose(const Mask& mask, const BasicInterval& a, const BasicInterval& b) {
    const BasicInterval either = hull(a, b);
    return of_ends(where_else(mask.yes, a.negative_low, where_else(mask.no, b.negative_low, either.negative_low)),
                   where_else(mask.yes, a.high, where_else(mask.no, b.high, either.high)));
  }

  // Derivatives of what may jump: of a choice, and of the angle of (x, y), which does where y changes its sign and x is not above zero.
  friend BasicInterval settled(const Mask& mask, const BasicInterval& derivative) { return where(mask.yes || mask.no, derivative); }
  friend BasicInterval uncut(const BasicInterval& y, const BasicInterval& x, const BasicInterval& derivative) {
    const S zero(0.0);
    return where((x.negative_low < zero || y.negative_low < zero || y.high < zero) && both_bounded(x, y), derivative);
  }

  // All numbers of both.
  friend BasicInterval hull(const BasicInterval& a, const BasicInterval& b) {
    return of_ends(most(a.negative_low, b.negative_low), most(a.high, b.high));
  }
  // Of two that hold the same number; of one of which nothing is known, the other.
  friend BasicInterval common(const BasicInterval& a, const BasicInterval& b) {
    const BasicInterval inner = of_ends(least(a.negative_low, b.negative_low), least(a.high, b.high));
    const auto of_a = a.is_bounded(), of_b = b.is_bounded();
    return of_ends(where_else(of_a && of_b, inner.negative_low, where_else(of_a, a.negative_low, b.negative_low)),
                   where_else(of_a && of_b, inner.high, where_else(of_a, a.high, b.high)));
  }
  friend BasicInterval smaller(const BasicInterval& a, const BasicInterval& b) {
    return where(both_bounded(a, b), of_ends(most(a.negative_low, b.negative_low), least(a.high, b.high)));
  }
  friend BasicInterval larger(const BasicInterval& a, const BasicInterval& b) { return -smaller(-a, -b); }
  friend BasicInterval abs(const BasicInterval& a) { return of_ends(-a.mignitude(), a.magnitude()); }

  friend BasicInterval square(const BasicInterval& a) {
    const S farthest = a.magnitude(), nearest_opposite = least(S(0.0), least(a.negative_low, a.high));
    return of_ends(nearest_opposite * -nearest_opposite, farthest * farthest);
  }
  // Rounded upward, r = sqrt(low) is exact or the number next above: exact where r r, rounded upward too, is not more than low. Else the
  // number next below, which is where anything less than a unit in the last place leads: the root of no positive number is below 2^-537.
  // Of a negative number it is none, and not taken; an infinite end stays one.
  friend BasicInterval sqrt(const BasicInterval& a) {
    const S low = -a.negative_low, r = sqrt(low);
    const S n = where_else(low < r * r, S(0x1p-700), S(0.0)) - r;
    return where(!(S(0.0) < a.negative_low), of_ends(n, sqrt(a.high)));
  }
  friend BasicInterval hypot(const BasicInterval& a, const BasicInterval& b) { return sqrt(square(a) + square(b)); }

  friend BasicInterval sin(const BasicInterval& a) {
    return on_lanes([](const Ends& x) { return ends::sin(x); }, a);
  }
  friend BasicInterval cos(const BasicInterval& a) {
    return on_lanes([](const Ends& x) { return ends::cos(x); }, a);
  }
  friend BasicInterval tan(const BasicInterval& a) { return on_lanes(ends::tan, a); }
  friend BasicInterval asin(const BasicInterval& a) { return on_lanes(ends::asin, a); }
  friend BasicInterval acos(const BasicInterval& a) { return on_lanes(ends::acos, a); }
  friend BasicInterval atan(const BasicInterval& a) { return on_lanes(ends::atan, a); }
  friend BasicInterval atan2(const BasicInterval& y, const BasicInterval& x) { return on_lanes(ends::atan2, y, x); }
  friend BasicInterval exp(const BasicInterval& a) { return on_lanes(ends::exp, a); }
  friend BasicInterval log(const BasicInterval& a) { return on_lanes(ends::log, a); }
  friend BasicInterval sinh(const BasicInterval& a) { return on_lanes(ends::sinh, a); }
  friend BasicInterval cosh(const BasicInterval& a) { return on_lanes(ends::cosh, a); }
  friend BasicInterval tanh(const BasicInterval& a) { return on_lanes(ends::tanh, a); }
  friend BasicInterval pow(const BasicInterval& a, double n) {
    if (n == 2) return square(a);
    return on_lanes([n](const Ends& x) { return ends::pow(x, n); }, a);
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  template <class C>
  static S where_else(const C& condition, const S& a, const S& b) {
    return choose(condition, a, b);
  }
  template <class C>
  static BasicInterval where(const C& known, const BasicInterval& a) {
    return of_ends(choose(known, a.negative_low, S(infinite)), choose(known, a.high, S(infinite)));
  }
  static S most(const S& a, const S& b) { return choose(a < b, b, a); }
  static S least(const S& a, const S& b) { return choose(b < a, b, a); }
  static auto both_bounded(const BasicInterval& a, const BasicInterval& b) { return most(a.magnitude(), b.magnitude()) < S(infinite); }
};

using Interval = BasicInterval<double>;

template <class F, class... X>
Interval on_lanes(F&& f, const Interval& a, const X&... b) {
  const Ends r = f(Ends{a.negative_low, a.high}, Ends{b.negative_low, b.high}...);
  return Interval::of_ends(r.negative_low, r.high);
}

}  // namespace pmreport::program

PMREPORT_EIGEN_SCALAR(pmreport::program::BasicInterval<S>, class S)
