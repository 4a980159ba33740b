// Taylor series of a function of time over a span of time, in intervals: coefficient k holds f^(k)(t) / k! at every t of the span.
// To be included where rounding goes upward alone (program/interval.hpp).
//
// Of y = f(a), with y' = g a' and g a series that is known to order k - 1 when coefficient k is due:
//
//   k y_k = sum of i a_i g_(k-i), i from 1 to k.
//
// That is all of exp (g = y), sin and cos (of one another), log (g = 1/a), atan (g = 1/(1 + a^2)), and so on; products and quotients are
// Cauchy's. Moore, Interval Analysis, 1966, chapter 11.
#pragma once

#include <array>
#include <cmath>
#include <core/program/intervals/interval.hpp>
#include <limits>
#include <span>
#include <vector>

namespace pmreport::scenario {

using program::Interval;

// Where a function goes over from one branch to another in the span, or at its end, its derivatives are those of both: at every instant
// each coefficient holds what either side has. How many derivatives are continuous even so is `smooth`: 0 of |x|, -1 where the value jumps.
//
// Up to order 1 it is the range of a function, and of its rate, where there is a value at all: what lies outside the domain is left out. Of
// a higher order it knows nothing where the function may be undefined.
template <int K>
struct Series {
  static constexpr int always = std::numeric_limits<int>::max();

  std::array<Interval, K + 1> c;
  int degree = 0;  // the coefficients beyond are zero
  int smooth = always;

  explicit Series(double constant = 0) {
    c.fill(Interval(0.0));
    c[0] = Interval(constant);
  }
  static Series time(const Interval& span) {
    Series out;
    out.c[0] = span;
    if constexpr (K > 0) out.c[1] = Interval(1.0);
    out.degree = 1;
    return out;
  }

  int last() const { return std::min(K, degree); }
  Interval& operator[](int k) { return c[static_cast<std::size_t>(k)]; }
  const Interval& operator[](int k) const { return c[static_cast<std::size_t>(k)]; }
};

// The value of a function of x; its coefficients, and whether it is anything but constant, are still to come.
template <int K>
Series<K> begun(const Interval& value, const Series<K>& x) {
  Series<K> out;
  out[0] = value;
  out.degree = x.degree > 0 ? K : 0;
  out.smooth = x.smooth;
  return out;
}
template <int K>
Series<K> begun(const Interval& value, const Series<K>& x, const Series<K>& y) {
  Series<K> out = begun(value, x);
  out.degree = std::max(x.degree, y.degree) > 0 ? K : 0;
  out.smooth = std::min(x.smooth, y.smooth);
  return out;
}

// sum of i a_i g_(k-i) / k
template <int K>
Interval next(int k, const Series<K>& a, const Series<K>& g) {
  Interval sum(0.0);
  for (int i = 1; i <= std::min(k, a.degree); ++i) sum = sum + (a[i] * static_cast<double>(i)) * g[k - i];
  return sum / static_cast<double>(k);
}
// y from its value and y' = g a'.
template <int K, class G>
Series<K> primitive(const Interval& value, const Series<K>& a, G&& g) {
  Series<K> y = begun(value, a);
  if (a.degree == 0) return y;
  const Series<K> slope = g();
  for (int k = 1; k <= K; ++k) y[k] = next(k, a, slope);
  return y;
}

template <int K>
Series<K> operator-(const Series<K>& x) {
  Series<K> y = x;
  for (int k = 0; k <= x.last(); ++k) y[k] = -x[k];
  return y;
}
template <int K, class Each>
Series<K> by_each(const Series<K>& x, const Series<K>& y, Each&& each) {
  Series<K> z = begun(each(x[0], y[0]), x, y);
  z.degree = std::max(x.degree, y.degree);
  for (int k = 1; k <= z.last(); ++k) z[k] = each(x[k], y[k]);
  return z;
}
template <int K>
Series<K> operator+(const Series<K>& x, const Series<K>& y) {
  return by_each(x, y, [](const Interval& a, const Interval& b) { return a + b; });
}
template <int K>
Series<K> operator-(const Series<K>& x, const Series<K>& y) {
  return by_each(x, y, [](const Interval& a, const Interval& b) { return a - b; });
}
template <int K>
Series<K> operator*(const Series<K>& x, const Series<K>& y) {
  Series<K> z = begun(x[0] * y[0], x, y);
  z.degree = std::min(K, x.degree + y.degree);
  for (int k = 1; k <= z.last(); ++k) {
    Interval sum(0.0);
    for (int i = std::max(0, k - y.degree); i <= std::min(k, x.degree); ++i) sum = sum + x[i] * y[k - i];
    z[k] = sum;
  }
  return z;
}
template <int K>
Series<K> square(const Series<K>& x) {
  Series<K> z = begun(square(x[0]), x);
  z.degree = std::min(K, 2 * x.degree);
  if constexpr (K == 0) return z;
  for (int k = 1; k <= z.last(); ++k) {
    Interval pairs(0.0);
    for (int i = std::max(0, k - x.degree); 2 * i < k; ++i) pairs = pairs + x[i] * x[k - i];
    z[k] = k % 2 == 0 ? pairs * 2.0 + square(x[k / 2]) : pairs * 2.0;
  }
  return z;
}
template <int K>
Series<K> operator/(const Series<K>& x, const Series<K>& y) {
  Series<K> q = begun(x[0] / y[0], x, y);
  for (int k = 1; k <= q.last(); ++k) {
    Interval rest = x[k];
    for (int i = 1; i <= std::min(k, y.degree); ++i) rest = rest - y[i] * q[k - i];
    q[k] = rest / y[0];
  }
  return q;
}

// What lies outside the domain of a function is left out where ranges alone are asked for.
template <int K>
Series<K> in_domain(const Series<K>& x, double low, double high) {
  Series<K> out = x;
  if constexpr (K < 2)
    if (x[0].bounded()) out[0] = Interval(std::clamp(x[0].low(), low, high), std::clamp(x[0].high, low, high));
  return out;
}

template <int K>
Series<K> exp(const Series<K>& a) {
  Series<K> y = begun(exp(a[0]), a);
  for (int k = 1; k <= y.last(); ++k) y[k] = next(k, a, y);
  return y;
}
template <int K>
Series<K> log(const Series<K>& a) {
  return primitive(log(a[0]), a, [&] { return Series<K>(1) / a; });
}

// Two that are one another's derivative but for a sign.
template <int K>
struct Pair {
  Series<K> first, second;
  Pair(const Series<K>& a, const Interval& of_first, const Interval& of_second, double sign)
      : first(begun(of_first, a)), second(begun(of_second, a)) {
    for (int k = 1; k <= first.last(); ++k) {
      first[k] = next(k, a, second);
      second[k] = next(k, a, first) * sign;
    }
  }
};
template <int K>
Series<K> sin(const Series<K>& a) {
  return Pair<K>(a, sin(a[0]), cos(a[0]), -1).first;
}
template <int K>
Series<K> cos(const Series<K>& a) {
  return Pair<K>(a, sin(a[0]), cos(a[0]), -1).second;
}
template <int K>
Series<K> sinh(const Series<K>& a) {
  return Pair<K>(a, sinh(a[0]), cosh(a[0]), 1).first;
}
template <int K>
Series<K> cosh(const Series<K>& a) {
  return Pair<K>(a, sinh(a[0]), cosh(a[0]), 1).second;
}

// y' = (1 + sign y^2) a'
template <int K>
Series<K> tangent(const Interval& value, const Series<K>& a, double sign) {
  Series<K> y = begun(value, a), slope = begun(1.0 + square(value) * sign, a);
  for (int k = 1; k <= y.last(); ++k) {
    y[k] = next(k, a, slope);
    Interval sum(0.0);
    for (int i = 0; i <= k; ++i) sum = sum + y[i] * y[k - i];
    slope[k] = sum * sign;
  }
  return y;
}
template <int K>
Series<K> tan(const Series<K>& a) {
  return tangent(tan(a[0]), a, 1);
}
template <int K>
Series<K> tanh(const Series<K>& a) {
  return tangent(tanh(a[0]), a, -1);
}

template <int K>
Series<K> sqrt(const Series<K>& a) {
  Series<K> y = begun(sqrt(a[0]), a);
  const Interval twice = y[0] * 2.0;
  for (int k = 1; k <= y.last(); ++k) {
    Interval rest = a[k];
    for (int i = 1; i < k; ++i) rest = rest - y[i] * y[k - i];
    y[k] = rest / twice;
  }
  return y;
}
template <int K>
Series<K> asin(const Series<K>& a) {
  return primitive(asin(a[0]), a, [&] { return Series<K>(1) / sqrt(Series<K>(1) - square(a)); });
}
template <int K>
Series<K> acos(const Series<K>& a) {
  return primitive(acos(a[0]), a, [&] { return Series<K>(-1) / sqrt(Series<K>(1) - square(a)); });
}
template <int K>
Series<K> atan(const Series<K>& a) {
  return primitive(atan(a[0]), a, [&] { return Series<K>(1) / (Series<K>(1) + square(a)); });
}

// y' = (x y' - y x') / (x^2 + y^2), on both sides of the ray on which the angle jumps by a turn.
template <int K>
Series<K> atan2(const Series<K>& y, const Series<K>& x) {
  Series<K> angle = begun(atan2(y[0], x[0]), y, x);
  if (!(x[0].low() > 0 || y[0].low() > 0 || y[0].high < 0)) angle.smooth = -1;
  if (angle.degree == 0) return angle;
  const Series<K> distance = square(x) + square(y);
  Series<K> area = begun(Interval(0.0), y, x);
  for (int k = 0; k < K; ++k) {
    Interval sum(0.0);
    for (int i = 0; i <= k; ++i) sum = sum + (x[i] * y[k - i + 1] - y[i] * x[k - i + 1]) * static_cast<double>(k - i + 1);
    area[k] = sum;
  }
  const Series<K> rate = area / distance;
  for (int k = 1; k <= K; ++k) angle[k] = rate[k - 1] / static_cast<double>(k);
  return angle;
}

// x^n of a whole n by squares; else from a p' = n p a':  k a_0 p_k = sum of (i n - (k - i)) a_i p_(k-i). At a = 0 that is no more; there
// the first two derivatives are n a^(n-1) a' and so on, as long as they exist.
template <int K>
Series<K> power(const Series<K>& x, double n) {
  const Series<K> a = n == std::round(n) ? x : in_domain(x, 0, std::numeric_limits<double>::infinity());
  if (n == 0) return begun(a[0] * 0.0 + 1.0, Series<K>(1));  // of a number that exists
  if (n == 1) return a;
  Series<K> y = begun(pow(a[0], n), a);
  if (y.degree == 0) return y;
  if (n == std::round(n)) {
    Series<K> product(1), factor = a;
    for (double left = std::abs(n); left > 0; left = std::floor(left / 2)) {
      if (std::fmod(left, 2) == 1) product = product * factor;
      if (left > 1) factor = square(factor);
    }
    if (n < 0) product = Series<K>(1) / product;
    product[0] = y[0];
    return product;
  }
  const Interval exponent(n);
  if (a[0].low() > 0) {
    for (int k = 1; k <= K; ++k) {
      Interval sum(0.0);
      for (int i = 1; i <= std::min(k, a.degree); ++i)
        sum = sum + (exponent * static_cast<double>(i) - static_cast<double>(k - i)) * (a[i] * y[k - i]);
      y[k] = sum / (a[0] * static_cast<double>(k));
    }
    return y;
  }
  const Interval slope = exponent * pow(a[0], n - 1);
  for (int k = 1; k <= K; ++k) y[k] = Interval::unbounded();
  if constexpr (K > 0) y[1] = slope * a[1];
  if constexpr (K > 1) y[2] = slope * a[2] + exponent * (exponent - 1.0) * 0.5 * pow(a[0], n - 2) * square(a[1]);
  return y;
}

// Both of two branches, of which the value is known.
template <int K>
Series<K> either(const Interval& value, const Series<K>& x, const Series<K>& y) {
  Series<K> out = by_each(x, y, [](const Interval& a, const Interval& b) { return hull(a, b); });
  out[0] = value;
  out.smooth = std::min(out.smooth, 0);
  return out;
}
template <int K>
Series<K> abs(const Series<K>& x) {
  if (x[0].low() > 0) return x;
  if (x[0].high < 0) return -x;
  return either(abs(x[0]), x, -x);
}
template <int K>
Series<K> minimum(const Series<K>& x, const Series<K>& y) {
  const bool first = x[0].high < y[0].low(), second = y[0].high < x[0].low();
  if (x[0].bounded() && y[0].bounded() && (first || second)) return first ? x : y;
  return either(smaller(x[0], y[0]), x, y);
}
template <int K>
Series<K> maximum(const Series<K>& x, const Series<K>& y) {
  return -minimum(-x, -y);
}

// Twice continuously differentiable where it begins and ends: the polynomial's first two derivatives are zero there, as those beyond are,
// so that u cut off at 0 and 1 gives both sides of them.
template <int K>
Series<K> step5(const Series<K>& x, const Series<K>& from, const Series<K>& to) {
  Series<K> u = (x - from) / (to - from);
  const Interval all = u[0];
  if (all.bounded() && (all.high < 0 || all.low() > 1)) return Series<K>(all.high < 0 ? 0 : 1);
  if (all.bounded()) u[0] = Interval(std::clamp(all.low(), 0.0, 1.0), std::clamp(all.high, 0.0, 1.0));
  const auto at = [](double v) {
    const Interval p(v);
    return p * p * p * (10.0 + p * (6.0 * p - 15.0));
  };
  const Series<K> one(1);
  Series<K> y = all.bounded() && all.low() > 0 && all.high < 1 ? u * square(u) * (Series<K>(10) + u * (Series<K>(6) * u - Series<K>(15)))
                                                               : begun(Interval::unbounded(), u);
  y[0] = all.bounded() ? common(hull(at(u[0].low()), at(u[0].high)), Interval(0.0, 1.0)) : Interval::unbounded();
  if (y.degree == 0) return y;
  const Interval v = 1.0 - u[0], slope = 30.0 * (square(u[0]) * square(v)), bend = 60.0 * (u[0] * v * (v - u[0]));
  if constexpr (K > 0) y[1] = slope * u[1];
  if constexpr (K > 1) y[2] = slope * u[2] + 0.5 * (bend * square(u[1]));
  if (!(all.bounded() && all.low() > 0 && all.high < 1)) {
    y.smooth = std::min(y.smooth, 2);
    for (int k = 3; k <= K; ++k) y[k] = Interval::unbounded();
  }
  return y;
}

}  // namespace pmreport::scenario
