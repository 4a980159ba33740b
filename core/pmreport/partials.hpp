// A value with its first partial derivatives in M directions, by forward accumulation.
#pragma once

#include <array>
#include <pmreport/scalar.hpp>

namespace pmreport {

template <class S, int M>
struct Partials {
  S value{};
  std::array<S, M> partial{};

  Partials() = default;
  Partials(double constant) : value(constant) { partial.fill(S(0.0)); }  // implicit: constants stay readable
  Partials(const S& v, const std::array<S, M>& p) : value(v), partial(p) {}

  // The coordinate number `direction`: its derivative by itself is one.
  static Partials variable(const S& v, int direction) {
    Partials x(0.0);
    x.value = v;
    x.partial[static_cast<std::size_t>(direction)] = S(1.0);
    return x;
  }

  // f(x, y) from f and its two derivatives, and f(x) from f and f'.
  static Partials combine(const S& f, const Partials& x, const S& fx, const Partials& y, const S& fy) {
    Partials r;
    r.value = f;
    for (std::size_t i = 0; i < M; ++i) r.partial[i] = fx * x.partial[i] + fy * y.partial[i];
    return r;
  }
  static Partials chain(const S& f, const Partials& x, const S& df) {
    Partials r;
    r.value = f;
    for (std::size_t i = 0; i < M; ++i) r.partial[i] = df * x.partial[i];
    return r;
  }

  Partials operator-() const {
    Partials r;
    r.value = -value;
    for (std::size_t i = 0; i < M; ++i) r.partial[i] = -partial[i];
    return r;
  }
  Partials& operator+=(const Partials& o) { return *this = *this + o; }
  Partials& operator-=(const Partials& o) { return *this = *this - o; }
  Partials& operator*=(const Partials& o) { return *this = *this * o; }
  Partials& operator/=(const Partials& o) { return *this = *this / o; }

  friend Partials operator+(const Partials& x, const Partials& y) {
    Partials r;
    r.value = x.value + y.value;
    for (std::size_t i = 0; i < M; ++i) r.partial[i] = x.partial[i] + y.partial[i];
    return r;
  }
  friend Partials operator-(const Partials& x, const Partials& y) {
    Partials r;
    r.value = x.value - y.value;
    for (std::size_t i = 0; i < M; ++i) r.partial[i] = x.partial[i] - y.partial[i];
    return r;
  }
  friend Partials operator*(const Partials& x, const Partials& y) { return combine(x.value * y.value, x, y.value, y, x.value); }
  friend Partials operator/(const Partials& x, const Partials& y) {
    const S inverse = 1.0 / y.value;
    const S q = x.value * inverse;
    return combine(q, x, inverse, y, -(q * inverse));
  }
  friend Partials operator+(const Partials& x, double c) { return {x.value + c, x.partial}; }
  friend Partials operator+(double c, const Partials& x) { return x + c; }
  friend Partials operator-(const Partials& x, double c) { return {x.value - c, x.partial}; }
  friend Partials operator-(double c, const Partials& x) { return -x + c; }
  friend Partials operator*(const Partials& x, double c) { return chain(x.value * c, x, S(c)); }
  friend Partials operator*(double c, const Partials& x) { return x * c; }
  friend Partials operator/(const Partials& x, double c) { return x * (1.0 / c); }
  friend Partials operator/(double c, const Partials& x) {
    const S q = c / x.value;
    return chain(q, x, -(q / x.value));
  }

  // Comparisons look at the value alone.
  friend auto operator<(const Partials& x, const Partials& y) { return x.value < y.value; }
  friend auto operator>(const Partials& x, const Partials& y) { return x.value > y.value; }
  friend auto operator<(const Partials& x, double c) { return x.value < c; }
  friend auto operator>(const Partials& x, double c) { return x.value > c; }

  template <class Mask>
  friend Partials choose(const Mask& mask, const Partials& x, const Partials& y) {
    Partials r;
    r.value = choose(mask, x.value, y.value);
    for (std::size_t i = 0; i < M; ++i) r.partial[i] = choose(mask, x.partial[i], y.partial[i]);
    return r;
  }

  friend Partials sqrt(const Partials& x) {
    const S root = sqrt(x.value);
    return chain(root, x, 0.5 / root);
  }
  friend Partials sin(const Partials& x) { return chain(sin(x.value), x, cos(x.value)); }
  friend Partials cos(const Partials& x) { return chain(cos(x.value), x, -sin(x.value)); }
  friend Partials tan(const Partials& x) {
    const S t = tan(x.value);
    return chain(t, x, t * t + 1.0);
  }
  friend Partials asin(const Partials& x) { return chain(asin(x.value), x, 1.0 / sqrt(1.0 - x.value * x.value)); }
  friend Partials acos(const Partials& x) { return chain(acos(x.value), x, -1.0 / sqrt(1.0 - x.value * x.value)); }
  friend Partials atan2(const Partials& y, const Partials& x) {
    const S inverse = 1.0 / (x.value * x.value + y.value * y.value);
    return combine(atan2(y.value, x.value), y, x.value * inverse, x, -(y.value * inverse));
  }
  friend Partials hypot(const Partials& x, const Partials& y) { return sqrt(x * x + y * y); }
  friend Partials abs(const Partials& x) { return choose(x < 0.0, -x, x); }
};

}  // namespace pmreport

#define PMREPORT_PARTIALS pmreport::Partials<S, M>
PMREPORT_EIGEN_SCALAR(PMREPORT_PARTIALS, class S, int M)
#undef PMREPORT_PARTIALS
