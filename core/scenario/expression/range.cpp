#include <algorithm>
#include <cmath>
#include <core/scenario/expression/range.hpp>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace pmreport::scenario {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(), pi = std::numbers::pi;
constexpr Range anything{-infinite, infinite};

// The smallest range with all of these; what is no number bounds nothing.
Range hull(std::initializer_list<double> values) {
  Range out{infinite, -infinite};
  for (const double x : values) {
    if (std::isnan(x)) return anything;
    out = {std::min(out.low, x), std::max(out.high, x)};
  }
  return out;
}

template <class F>
Range rising(F&& f, const Range& x) {
  return hull({f(x.low), f(x.high)});
}

Range product(const Range& a, const Range& b) { return hull({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high}); }
Range quotient(const Range& a, const Range& b) {
  if (b.has(0)) return anything;
  return hull({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
}

// |x| is lowest at zero.
Range magnitude(const Range& x) {
  const Range ends = hull({std::abs(x.low), std::abs(x.high)});
  return {x.has(0) ? 0 : ends.low, ends.high};
}

Range power(const Range& x, double n) {
  const bool whole = n == std::round(n);
  if (n < 0 && x.has(0)) return anything;
  const auto f = [n](double v) { return std::pow(v, n); };
  if (!whole) return rising(f, {std::max(x.low, 0.0), std::max(x.high, 0.0)});
  return std::fmod(n, 2) == 0 ? rising(f, magnitude(x)) : rising(f, x);
}

// Of the sine: its ends, and the crests and troughs, pi/2 + k pi, that lie between them.
Range sine(const Range& x) {
  constexpr double countable = 1e15;  // [rad]: beyond it neighbouring numbers are a crest apart
  if (!(x.width() < 2 * pi) || !(magnitude(x).high < countable)) return {-1, 1};
  Range out = hull({std::sin(x.low), std::sin(x.high)});
  for (double k = std::ceil((x.low - pi / 2) / pi); pi / 2 + k * pi <= x.high; ++k)
    std::fmod(k, 2) == 0 ? void(out.high = 1) : void(out.low = -1);
  return out;
}

Range tangent(const Range& x) {
  const double pole = pi / 2 + std::ceil((x.low - pi / 2) / pi) * pi;
  if (!(x.width() < pi) || pole <= x.high) return anything;
  return rising([](double v) { return std::tan(v); }, x);
}

// The angle of a box is that of its corners, unless the box holds the origin or touches the ray at which the angle jumps.
Range angle(const Range& y, const Range& x) {
  if (y.has(0) && x.low <= 0) return {-pi, pi};
  return hull({std::atan2(y.low, x.low), std::atan2(y.low, x.high), std::atan2(y.high, x.low), std::atan2(y.high, x.high)});
}

double step(double u) {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * u * (10 + u * (6 * u - 15));
}

Range apply(const Term& term, const Range& a, const Range& b, const Range& c, const Range& time) {
  const auto clipped = [&](double low, double high) { return Range{std::clamp(a.low, low, high), std::clamp(a.high, low, high)}; };
  switch (term.operation) {
    case Operation::constant:
      return {term.constant, term.constant};
    case Operation::time:
      return time;
    case Operation::variable:
      return anything;
    case Operation::negate:
      return {-a.high, -a.low};
    case Operation::add:
      return hull({a.low + b.low, a.high + b.high});
    case Operation::subtract:
      return hull({a.low - b.high, a.high - b.low});
    case Operation::multiply:
      return product(a, b);
    case Operation::divide:
      return quotient(a, b);
    case Operation::power:
      return power(a, term.constant);
    case Operation::sin:
      return sine(a);
    case Operation::cos:
      return sine({a.low + pi / 2, a.high + pi / 2});
    case Operation::tan:
      return tangent(a);
    case Operation::asin:
      return rising([](double v) { return std::asin(v); }, clipped(-1, 1));
    case Operation::acos:
      return rising([](double v) { return std::acos(v); }, clipped(-1, 1));
    case Operation::atan:
      return rising([](double v) { return std::atan(v); }, a);
    case Operation::atan2:
      return angle(a, b);
    case Operation::sinh:
      return rising([](double v) { return std::sinh(v); }, a);
    case Operation::cosh:
      return rising([](double v) { return std::cosh(v); }, magnitude(a));
    case Operation::tanh:
      return rising([](double v) { return std::tanh(v); }, a);
    case Operation::sqrt:
      return rising([](double v) { return std::sqrt(v); }, clipped(0, infinite));
    case Operation::exp:
      return rising([](double v) { return std::exp(v); }, a);
    case Operation::log:
      return rising([](double v) { return std::log(v); }, clipped(0, infinite));
    case Operation::abs:
      return magnitude(a);
    case Operation::min:
      return {std::min(a.low, b.low), std::min(a.high, b.high)};
    case Operation::max:
      return {std::max(a.low, b.low), std::max(a.high, b.high)};
    case Operation::step5: {
      const Range u = quotient({a.low - b.high, a.high - b.low}, {c.low - b.high, c.high - b.low});
      return {step(u.low), step(u.high)};
    }
  }
  return anything;
}

}  // namespace

void ranges_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out) {
  out.resize(terms.size());
  const auto of = [&](int i) { return i < 0 ? Range{} : out[static_cast<std::size_t>(i)]; };
  for (std::size_t i = 0; i < terms.size(); ++i) out[i] = apply(terms[i], of(terms[i].a), of(terms[i].b), of(terms[i].c), {begin, end});
}

}  // namespace pmreport::scenario
