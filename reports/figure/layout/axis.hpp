// An axis: its range, its round ticks and the words beside them.
#pragma once

#include <string>
#include <vector>

#include <reports/figure/figure.hpp>

namespace pmreport::figure {

struct Tick {
  double value;       // [data units]
  std::string label;  // with a typographic minus, in units of 10^exponent above the offset
};

struct Scale {
  double low = 0, high = 1;
  std::vector<Tick> major;
  std::vector<double> minor;
  int exponent = 0;   // labels count multiples of 10^exponent
  double offset = 0;  // labels count from here; 0 unless the range is tiny beside its values

  double position(double value) const { return (value - low) / (high - low); }  // 0 at low, 1 at high
};

// The scale of [low, high], which must be an interval in which doubles are still distinct (see `widened`), with about `wanted` major ticks.
Scale make_scale(double low, double high, int wanted);

// "limb length [mm]", "limb length − 812.4 [10⁻³ mm]".
std::string axis_title(const Axis& axis, const Scale& scale);

// A number as an author would set it: "−812.4", "3.1×10⁵"; `significant` digits, 0 for the shortest text that reads back the same.
std::string typeset(double value, int significant = 0);

// The largest magnitude drawn: differences and ticks of such values are still finite.
constexpr double largest = 1e300;

// [low, high] clamped to the drawable magnitudes and, where it has no width beyond rounding, opened to a sensible one.
struct Interval {
  double low, high;
};
Interval widened(Interval interval);

// Round tick values covering [low, high]: steps of 1, 2, 2.5 or 5 times a power of ten, about `wanted` of them.
std::vector<double> ticks(double low, double high, int wanted);

}  // namespace pmreport::figure
