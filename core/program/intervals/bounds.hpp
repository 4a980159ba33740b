// What is known of a number: it lies between two. Plain data, safe anywhere; the arithmetic is that of interval.hpp, where rounding goes
// upward.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::program {

// Both ends included. Not bounded, an end infinite: nothing is known, not even that there is such a number.
struct Bounds {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();

  static constexpr Bounds exactly(double x) { return {x, x}; }
  bool bounded() const { return std::isfinite(low) && std::isfinite(high); }
  bool has(double x) const { return low <= x && x <= high; }
  double width() const { return high - low; }                 // rounded
  double middle() const { return low + 0.5 * (high - low); }  // rounded, but never outside
  bool operator==(const Bounds&) const = default;

  friend Bounds hull(const Bounds& a, const Bounds& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }
  // Of two that hold the same number. Two that have none in common contradict each other, and nothing is known.
  friend Bounds common(const Bounds& a, const Bounds& b) {
    const Bounds out{std::max(a.low, b.low), std::min(a.high, b.high)};
    return out.low <= out.high ? out : Bounds{};
  }
};

}  // namespace pmreport::program
