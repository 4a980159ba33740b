// A number, and how well it is known.
#pragma once

#include <cmath>
#include <limits>

namespace pmreport::analysis {

// The true number lies from low to high; the value, between them, is what tables and searches take. Of a number that is known as it stands
// all three are the same; NaN: there is none.
struct Bracketed {
  double value = std::numeric_limits<double>::quiet_NaN();
  double low = value, high = value;
  double resolution = 0;  // of a number that was counted on a grid: how far another grid may move it

  static Bracketed plain(double x) { return {x, x, x}; }
  static Bracketed between(double low, double high) { return {low + (high - low) / 2, low, high}; }
  static Bracketed counted(double x, double resolution) { return {x, x, x, resolution}; }
  bool known() const { return std::isfinite(value); }
  double width() const { return high - low; }
};

// Which of two numbers is the larger, as far as their brackets tell.
enum class Order { less, equal, greater, open };
inline Order order_of(const Bracketed& a, const Bracketed& b) {
  if (a.high < b.low) return Order::less;
  if (a.low > b.high) return Order::greater;
  return a.low == a.high && b.low == b.high && a.value == b.value ? Order::equal : Order::open;
}

}  // namespace pmreport::analysis
