#include <algorithm>
#include <cmath>
#include <core/scenario/motion/spline.hpp>

namespace pmreport::scenario {
namespace {

// The piece that holds t: between points i and i + 1.
std::size_t piece(const std::vector<double>& times, double t) {
  const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, t);
  return static_cast<std::size_t>(after - times.begin()) - 1;
}

// Rows of a tridiagonal system, lower x[i-1] + diagonal x[i] + upper x[i+1] = right; solved in place into `right`. The systems below are
// diagonally dominant, so that elimination needs no pivots.
struct Tridiagonal {
  explicit Tridiagonal(std::size_t n) : lower(n), diagonal(n), upper(n), right(n) {}
  void solve() {
    const std::size_t n = right.size();
    for (std::size_t i = 1; i < n; ++i) {
      const double f = lower[i] / diagonal[i - 1];
      diagonal[i] -= f * upper[i - 1];
      right[i] -= f * right[i - 1];
    }
    right[n - 1] /= diagonal[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) right[i] = (right[i] - upper[i] * right[i + 1]) / diagonal[i];
  }
  std::vector<double> lower, diagonal, upper, right;
};

}  // namespace

// With second derivatives M at the points, h[i] = t[i+1] - t[i] and slopes d[i] = (y[i+1] - y[i]) / h[i], a rate that is continuous at
// point i asks
//
//   h[i-1] M[i-1] + 2 (h[i-1] + h[i]) M[i] + h[i] M[i+1] = 6 (d[i] - d[i-1]).
//
// At rest at the first point:  2 h[0] M[0] + h[0] M[1] = 6 d[0], and its mirror image at the last.
// Not a knot at point 1, equal third derivatives on both sides:  M[0] = M[1] + (M[1] - M[2]) h[0] / h[1]. Put into the row of point 1:
//
//   (h[0] + h[1]) (h[0] + 2 h[1]) / h[1] M[1] + (h[1]^2 - h[0]^2) / h[1] M[2] = 6 (d[1] - d[0]), and its mirror image.
//
// Three points fix one parabola, two a straight line.
CubicSpline::CubicSpline(std::vector<double> times, std::vector<double> values, Ends ends)
    : times_(std::move(times)), values_(std::move(values)), bends_(times_.size(), 0.0) {
  const std::size_t n = times_.size(), last = n - 1;
  std::vector<double> h(last), d(last);
  for (std::size_t i = 0; i < last; ++i) {
    h[i] = times_[i + 1] - times_[i];
    d[i] = (values_[i + 1] - values_[i]) / h[i];
  }
  if (ends == Ends::not_a_knot && n <= 3) {
    if (n == 3) bends_.assign(3, 2 * (d[1] - d[0]) / (h[0] + h[1]));
    return;
  }
  Tridiagonal rows(n);
  for (std::size_t i = 1; i < last; ++i) {
    rows.lower[i] = h[i - 1];
    rows.diagonal[i] = 2 * (h[i - 1] + h[i]);
    rows.upper[i] = h[i];
    rows.right[i] = 6 * (d[i] - d[i - 1]);
  }
  if (ends == Ends::at_rest) {
    rows.diagonal[0] = 2 * h[0], rows.upper[0] = h[0], rows.right[0] = 6 * d[0];
    rows.lower[last] = h[last - 1], rows.diagonal[last] = 2 * h[last - 1], rows.right[last] = -6 * d[last - 1];
    rows.solve();
    bends_ = rows.right;
    return;
  }
  const auto eliminate_end = [&](std::size_t row, double outer, double inner, double& towards_end, double& inward) {
    towards_end = 0;
    rows.diagonal[row] = (outer + inner) * (outer + 2 * inner) / inner;
    inward = (inner - outer) * (inner + outer) / inner;
  };
  eliminate_end(1, h[0], h[1], rows.lower[1], rows.upper[1]);
  eliminate_end(last - 1, h[last - 1], h[last - 2], rows.upper[last - 1], rows.lower[last - 1]);
  rows.diagonal[0] = rows.diagonal[last] = 1;  // the end points stand alone until the inner ones are known
  rows.solve();
  bends_ = rows.right;
  bends_[0] = bends_[1] + (bends_[1] - bends_[2]) * h[0] / h[1];
  bends_[last] = bends_[last - 1] + (bends_[last - 1] - bends_[last - 2]) * h[last - 1] / h[last - 2];
}

Jet<double> CubicSpline::at(double t) const {
  const std::size_t i = piece(times_, t);
  const double h = times_[i + 1] - times_[i], s = t - times_[i];
  const double slope = (values_[i + 1] - values_[i]) / h - h * (2 * bends_[i] + bends_[i + 1]) / 6;
  const double jerk = (bends_[i + 1] - bends_[i]) / h;
  return {values_[i] + s * (slope + s * (bends_[i] / 2 + s * jerk / 6)), slope + s * (bends_[i] + s * jerk / 2), bends_[i] + s * jerk};
}

// The rate of a piece, a + b s + c s^2, vanishes where it turns. The roots by the form that loses no digits where b^2 dwarfs a c.
CubicSpline::Overshoot CubicSpline::overshoot() const {
  Overshoot out;
  for (std::size_t i = 0; i + 1 < times_.size(); ++i) {
    const double h = times_[i + 1] - times_[i];
    const Jet<double> start = at(times_[i]);
    const double a = start.rate, b = bends_[i], c = (bends_[i + 1] - bends_[i]) / h / 2;
    const double under = b * b - 4 * a * c;
    if (!(under >= 0)) continue;
    const double q = -0.5 * (b + std::copysign(std::sqrt(under), b));
    for (const double s : {q / c, a / q}) {
      if (!(s > 0 && s < h)) continue;
      const double y = at(times_[i] + s).value;
      const double beyond = std::max(y - std::max(values_[i], values_[i + 1]), std::min(values_[i], values_[i + 1]) - y);
      if (beyond > out.beyond) out = {beyond, times_[i] + s};
    }
  }
  return out;
}

// y = y0 + (y1 - y0) (10 u^3 - 15 u^4 + 6 u^5), u = (t - t0) / h: the lowest polynomial with zero rate and acceleration at both ends.
Jet<double> QuinticSteps::at(double t) const {
  const std::size_t i = piece(times_, t);
  const double h = times_[i + 1] - times_[i], step = values_[i + 1] - values_[i];
  const double u = std::clamp((t - times_[i]) / h, 0.0, 1.0), v = 1 - u;
  return {values_[i] + step * (u * u * u * (10 + u * (6 * u - 15))), step / h * (30 * u * u * v * v),
          step / (h * h) * (60 * u * v * (v - u))};
}

}  // namespace pmreport::scenario
