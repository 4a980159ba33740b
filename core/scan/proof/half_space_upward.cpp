#include <core/scan/proof/half_space.hpp>

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace pmreport::scan {

namespace {

using program::Bounds, program::Interval;

// With x = 2 u - 1 and both signs alike, the share is the chance that v.u <= t, u uniform in the unit cube, v = |w|, t = (c + sum v) / 2:
//     F(t) = sum over subsets S of (-1)^|S| max(0, t - sum of S)^d / (d! v_1 ... v_d).              (1)
// F(t) = 1 - F(sum v - t), so that t never needs to be above the half. The terms of (1) are as large as (sum v / 2)^d / (d! prod v) then,
// and cancel where some v are small beside the largest. The smallest are left out until that is below `most_cancelled`, and what is left
// out moves t about the middle of its way by Y, of mean zero, between -R / 2 and R / 2 with R the sum of what is left out:
//     F(t) = mean of F_kept(t - R / 2 - Y).                                                         (2)
// The density of v_1 u_1 + v_2 u_2 has slopes of 1 / (v_1 v_2) at most, and no more of them when further terms are added, so with two or
// more weights kept (2) is F_kept(t - R / 2) but for E[Y^2] / (2 v_1 v_2) = (sum of the squares left out) / (24 v_1 v_2). With one kept F
// is t / v_1 between its kinks at 0 and v_1, and (2) exact, unless Y may reach a kink: then F_kept(t - R) and F_kept(t) are bounds.
constexpr double most_cancelled = 1e4;

struct Weights {
  std::array<double, most_axes> v{};  // the largest first
  std::size_t kept = 0, size = 0;
  Interval sum{0.0}, sum_kept{0.0}, left_out{0.0}, squares_left_out{0.0};
  double scale_negative_low = -1, scale_high = 1;  // d! v_1 ... v_d of those kept
};

Weights sorted(std::span<const double> weights) {
  Weights w;
  for (const double x : weights)
    if (x != 0) w.v[w.size++] = std::abs(x);
  std::sort(w.v.begin(), w.v.begin() + static_cast<std::ptrdiff_t>(w.size), std::greater<>());
  // How far the terms of (1) cancel, one weight after the other.
  double sum = 0, product = 1;
  for (std::size_t k = 0; k < w.size; ++k) {
    sum += 0.5 * w.v[k] / w.v[0];
    product *= static_cast<double>(k + 1) * w.v[k] / w.v[0];
    double power = 1;
    for (std::size_t i = 0; i <= k; ++i) power *= sum;
    if (!(power <= most_cancelled * product)) break;
    w.kept = k + 1;
    w.scale_negative_low = w.scale_negative_low * w.v[k] * static_cast<double>(k + 1);
    w.scale_high = w.scale_high * w.v[k] * static_cast<double>(k + 1);
  }
  for (std::size_t k = 0; k < w.size; ++k) {
    const Interval v(w.v[k]);
    w.sum += v;
    if (k < w.kept) {
      w.sum_kept += v;
    } else {
      w.left_out += v;
      w.squares_left_out += square(v);
    }
  }
  return w;
}

// (1) of the weights kept, of which there is one or more; within 0 and 1. On the ends as they are, for no number in it but the terms' sum
// is negative: a product of a negative low end with a positive number goes outward by itself.
Interval lower_half(const Interval& t, const Weights& w) {
  double negative_low = 0, high = 0;
  for (std::size_t subset = 0; subset < std::size_t{1} << w.kept; ++subset) {
    double rest_negative_low = t.negative_low, rest_high = t.high;
    bool odd = false;
    for (std::size_t k = 0; k < w.kept; ++k)
      if (subset >> k & 1) {
        rest_negative_low += w.v[k];
        rest_high -= w.v[k];
        odd = !odd;
      }
    if (!(rest_high > 0)) continue;
    const double rest_low = std::max(0.0, -rest_negative_low);
    double term_negative_low = -1, term_high = 1;
    for (std::size_t k = 0; k < w.kept; ++k) {
      term_negative_low *= rest_low;
      term_high *= rest_high;
    }
    negative_low += odd ? term_high : term_negative_low;
    high += odd ? term_negative_low : term_high;
  }
  return {std::min(1.0, -(std::min(0.0, negative_low) / w.scale_high)), std::min(1.0, std::max(0.0, high) / -w.scale_negative_low)};
}
Interval share_kept(const Interval& t, const Weights& w) {
  if (t.high <= 0) return Interval(0.0);
  if (w.sum_kept.high <= t.low()) return Interval(1.0);
  if (t.middle() <= 0.5 * w.sum_kept.high) return lower_half(t, w);
  return 1.0 - lower_half(w.sum_kept - t, w);
}

Interval share(const Interval& t, const Weights& w) {
  if (t.high <= 0) return Interval(0.0);
  if (w.sum.high <= t.low()) return Interval(1.0);
  if (w.kept == w.size) return share_kept(t, w);
  if (w.kept == 1) {
    const Interval nearest = t - w.left_out;
    if (!(0 <= nearest.low() && t.high <= w.v[0])) return hull(share_kept(nearest, w), share_kept(t, w));
    return share_kept(t - 0.5 * w.left_out, w);
  }
  const double slack = (w.squares_left_out / (Interval(w.v[0]) * w.v[1] * 24.0)).high;
  const Interval about = share_kept(t - 0.5 * w.left_out, w) + Interval(-slack, slack);
  return {std::clamp(about.low(), 0.0, 1.0), std::clamp(about.high, 0.0, 1.0)};
}

}  // namespace

Bounds half_space_share_upward(Bounds c, std::span<const double> weights) {
  const Weights w = sorted(weights);
  if (w.size == 0) return {c.low >= 0 ? 1.0 : 0.0, c.high >= 0 ? 1.0 : 0.0};
  return {share((Interval(c.low) + w.sum) * 0.5, w).low(), share((Interval(c.high) + w.sum) * 0.5, w).high};
}

Bounds half_space_share(Bounds c, std::span<const double> weights) {
  return program::round_upward([&] { return half_space_share_upward(c, weights); });
}

}  // namespace pmreport::scan
