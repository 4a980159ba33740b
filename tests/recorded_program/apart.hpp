// How far apart two machines may come that run one program on one input, where their elementary functions agree to one unit of the last
// place and all else is IEEE 754: a number with a bound of its distance from the other's, carried through the program. Where no elementary
// function has a part in a number the bound is zero, and both must be equal to the last bit.
//
//     sum, difference        |dx| + |dy|
//     product                |x dy| + |y dx| + |dx dy|
//     quotient z = x / y     (|dx| + |z| |dy|) / (|y| - |dy|)
//     f(x)                   the most that f changes within |dx| of x
// Each then gets one unit of the last place where its operands differ, since both results are rounded: half a unit each. An elementary
// function gets a unit where its operands agree, and three where they do not: that unit, and what the function itself is off by, less than
// a unit, at either operand. A comparison that the bounds leave open makes a choice as far apart as its two values can be.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace apart {

constexpr double inf = std::numeric_limits<double>::infinity();

inline double unit_of(double x) {
  x = std::abs(x);
  return std::isfinite(x) ? std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1) - x : inf;
}

struct Mask {
  bool holds, sure;
};
inline Mask operator!(Mask a) { return {!a.holds, a.sure}; }
inline Mask operator&&(Mask a, Mask b) { return {a.holds && b.holds, (a.sure && b.sure) || (a.sure && !a.holds) || (b.sure && !b.holds)}; }
inline Mask operator||(Mask a, Mask b) { return !(!a && !b); }

struct Number {
  double value = 0, off = 0;  // infinite: nothing is known
  Number() = default;
  Number(double x) : value(x) {}
  Number(double x, double bound) : value(x), off(std::isnan(bound) ? inf : bound) {}
};

// `change`: of the exact result. The bounds are computed in double themselves, hence the last factor.
inline Number rounded(double value, double change, double units) {
  return {value, (change + units * unit_of(std::abs(value) + change)) * (1 + 1e-12)};
}
inline bool same(const Number& a) { return a.off == 0; }

inline Number operator-(const Number& a) { return {-a.value, a.off}; }
inline Number operator+(const Number& a, const Number& b) {
  const double z = a.value + b.value;
  return same(a) && same(b) ? Number(z) : rounded(z, a.off + b.off, 1);
}
inline Number operator-(const Number& a, const Number& b) { return a + -b; }
inline Number operator*(const Number& a, const Number& b) {
  const double z = a.value * b.value;
  if (same(a) && same(b)) return z;
  return rounded(z, std::abs(a.value) * b.off + std::abs(b.value) * a.off + a.off * b.off, 1);
}
inline Number operator/(const Number& a, const Number& b) {
  const double z = a.value / b.value, least = std::abs(b.value) - b.off;
  if (same(a) && same(b)) return z;
  return least > 0 ? rounded(z, (a.off + std::abs(z) * b.off) / least, 1) : Number(z, inf);
}
inline Number abs(const Number& a) { return {std::abs(a.value), a.off}; }

// Of a function that rises or falls throughout: it changes most at one of the two ends. Where it ends before them nothing is known.
template <class F>
Number monotone(const Number& a, F&& f, double units_of_same, double units) {
  const double z = f(a.value);
  if (same(a)) return {z, units_of_same == 0 ? 0 : units_of_same * unit_of(z)};
  return rounded(z, std::max(std::abs(f(a.value + a.off) - z), std::abs(f(a.value - a.off) - z)), units);
}
inline Number sqrt(const Number& a) {
  return monotone(
      a, [](double x) { return std::sqrt(x); }, 0, 1);
}
inline Number asin(const Number& a) {
  return monotone(
      a, [](double x) { return std::asin(x); }, 1, 3);
}
inline Number acos(const Number& a) {
  return monotone(
      a, [](double x) { return std::acos(x); }, 1, 3);
}
inline Number tan(const Number& a) {
  if (a.off > 0.1 || std::abs(std::cos(a.value)) < 2 * a.off) return {std::tan(a.value), inf};
  return monotone(
      a, [](double x) { return std::tan(x); }, 1, 3);
}
// No slope is more than one.
inline Number sin(const Number& a) { return rounded(std::sin(a.value), a.off, same(a) ? 1 : 3); }
inline Number cos(const Number& a) { return rounded(std::cos(a.value), a.off, same(a) ? 1 : 3); }
inline Number hypot(const Number& a, const Number& b) {
  return rounded(std::hypot(a.value, b.value), a.off + b.off, same(a) && same(b) ? 1 : 3);
}
// Its gradient has the length 1 / r; across the negative axis it jumps.
inline Number atan2(const Number& a, const Number& b) {
  const double z = std::atan2(a.value, b.value), change = a.off + b.off, least = std::hypot(a.value, b.value) - change;
  if (same(a) && same(b)) return {z, unit_of(z)};
  if (!(least > 0) || (b.value - b.off < 0 && std::abs(a.value) <= a.off)) return {z, inf};
  return rounded(z, change / least, 3);
}

inline Mask operator<(const Number& a, const Number& b) {
  return {a.value < b.value, (same(a) && same(b)) || std::abs(a.value - b.value) > a.off + b.off};
}
inline Number choose(Mask mask, const Number& a, const Number& b) {
  const Number& chosen = mask.holds ? a : b;
  if (mask.sure) return chosen;
  return {chosen.value, std::max(a.off, b.off) + std::abs(a.value - b.value)};
}

// Whether `other` may be what the other machine has.
inline bool allows(const Number& x, double other) {
  if (std::isnan(x.value) || std::isinf(x.off)) return true;
  return x.off == 0 ? other == x.value && std::signbit(other) == std::signbit(x.value) : std::abs(other - x.value) <= x.off;
}

}  // namespace apart
