// Value, rate and acceleration of a quantity that moves in time: Taylor arithmetic of second order.
//
//   (x y)'  = x'y + xy'            (f(x))'  = f'(x) x'
//   (x y)'' = x''y + 2x'y' + xy''  (f(x))'' = f'(x) x'' + f''(x) x'^2
//
// Rates and accelerations of a placement follow exactly from the formulas that place it.
#pragma once

#include <pmreport/scalar.hpp>

namespace pmreport {

template <class S>
struct Jet {
  S value{}, rate{}, acceleration{};

  Jet() = default;
  Jet(double constant) : value(constant), rate(0.0), acceleration(0.0) {}  // implicit: constants stay readable
  Jet(const S& v, const S& r, const S& a) : value(v), rate(r), acceleration(a) {}

  Jet operator-() const { return {-value, -rate, -acceleration}; }
  Jet& operator+=(const Jet& o) { return *this = *this + o; }
  Jet& operator-=(const Jet& o) { return *this = *this - o; }
  Jet& operator*=(const Jet& o) { return *this = *this * o; }
  Jet& operator/=(const Jet& o) { return *this = *this / o; }

  friend Jet operator+(const Jet& x, const Jet& y) { return {x.value + y.value, x.rate + y.rate, x.acceleration + y.acceleration}; }
  friend Jet operator-(const Jet& x, const Jet& y) { return {x.value - y.value, x.rate - y.rate, x.acceleration - y.acceleration}; }
  friend Jet operator*(const Jet& x, const Jet& y) {
    return {x.value * y.value, x.rate * y.value + x.value * y.rate,
            x.acceleration * y.value + 2.0 * (x.rate * y.rate) + x.value * y.acceleration};
  }
  friend Jet operator/(const Jet& x, const Jet& y) {  // from x = q y, differentiated twice
    const S inverse = 1.0 / y.value;
    const S q = x.value * inverse;
    const S q_rate = (x.rate - q * y.rate) * inverse;
    return {q, q_rate, (x.acceleration - 2.0 * (q_rate * y.rate) - q * y.acceleration) * inverse};
  }
  friend Jet operator+(const Jet& x, double c) { return {x.value + c, x.rate, x.acceleration}; }
  friend Jet operator+(double c, const Jet& x) { return x + c; }
  friend Jet operator-(const Jet& x, double c) { return {x.value - c, x.rate, x.acceleration}; }
  friend Jet operator-(double c, const Jet& x) { return {c - x.value, -x.rate, -x.acceleration}; }
  friend Jet operator*(const Jet& x, double c) { return {x.value * c, x.rate * c, x.acceleration * c}; }
  friend Jet operator*(double c, const Jet& x) { return x * c; }
  friend Jet operator/(const Jet& x, double c) { return x * (1.0 / c); }
  friend Jet operator/(double c, const Jet& x) { return Jet(c) / x; }

  // Comparisons look at the value alone.
  friend auto operator<(const Jet& x, const Jet& y) { return x.value < y.value; }
  friend auto operator>(const Jet& x, const Jet& y) { return x.value > y.value; }
  friend auto operator<(const Jet& x, double c) { return x.value < c; }
  friend auto operator>(const Jet& x, double c) { return x.value > c; }

  template <class Mask>
  friend Jet choose(const Mask& mask, const Jet& x, const Jet& y) {
    return {choose(mask, x.value, y.value), choose(mask, x.rate, y.rate), choose(mask, x.acceleration, y.acceleration)};
  }

  // f(x) from f, f' and f'' at the value of x.
  friend Jet chain(const Jet& x, const S& f, const S& df, const S& ddf) {
    return {f, df * x.rate, df * x.acceleration + ddf * (x.rate * x.rate)};
  }
  friend Jet sqrt(const Jet& x) {
    const S root = sqrt(x.value);
    const S df = 0.5 / root;
    return chain(x, root, df, -0.5 * (df / x.value));
  }
  friend Jet sin(const Jet& x) {
    const S s = sin(x.value);
    return chain(x, s, cos(x.value), -s);
  }
  friend Jet cos(const Jet& x) {
    const S c = cos(x.value);
    return chain(x, c, -sin(x.value), -c);
  }
  friend Jet tan(const Jet& x) {
    const S t = tan(x.value);
    const S df = t * t + 1.0;
    return chain(x, t, df, 2.0 * (t * df));
  }
  friend Jet asin(const Jet& x) {
    const S u = 1.0 / (1.0 - x.value * x.value);
    const S df = sqrt(u);
    return chain(x, asin(x.value), df, x.value * (u * df));
  }
  friend Jet acos(const Jet& x) {
    const S u = 1.0 / (1.0 - x.value * x.value);
    const S df = -sqrt(u);
    return chain(x, acos(x.value), df, x.value * (u * df));
  }
  // The angle of (x, y): its rate is (x y' - y x') / (x^2 + y^2), differentiated once more.
  friend Jet atan2(const Jet& y, const Jet& x) {
    const S inverse = 1.0 / (x.value * x.value + y.value * y.value);
    const S rate = (x.value * y.rate - y.value * x.rate) * inverse;
    const S radial = 2.0 * (x.value * x.rate + y.value * y.rate);
    return {atan2(y.value, x.value), rate, (x.value * y.acceleration - y.value * x.acceleration - radial * rate) * inverse};
  }
  friend Jet hypot(const Jet& x, const Jet& y) { return sqrt(x * x + y * y); }
  friend Jet abs(const Jet& x) { return choose(x < 0.0, -x, x); }
};

}  // namespace pmreport

PMREPORT_EIGEN_SCALAR(pmreport::Jet<S>, class S)
