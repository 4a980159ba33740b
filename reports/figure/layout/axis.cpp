#include <reports/figure/layout/axis.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace pmreport::figure {
namespace {

constexpr double rounding = 1e-11;   // relative widths below this are rounding, not data
constexpr double smallest = 1e-290;  // magnitudes below this are zero
constexpr double slack = 1e-9;       // of a step: a tick this near to the end of a range is at its end

// Multiples k of a round step, mantissa·10^exponent with whole mantissa, so that each value is the double nearest to its decimal.
struct Steps {
  int mantissa;  // 1, 2, 5 or 25
  int exponent;
  double first, last;  // whole k; doubles, for a range far from zero overflows an int

  static double scaled(double whole, int exponent) {
    if (whole == 0) return 0;  // never "-0"
    return exponent >= 0 ? whole * std::pow(10.0, exponent) : whole / std::pow(10.0, -exponent);
  }
  double value(double k) const { return scaled(k * mantissa, exponent); }
  double step() const { return value(1); }
  double count() const { return last - first + 1; }
  // 1 | 5 parts, 2 | 4 parts, 2.5 | 5 parts, 5 | 5 parts: a minor step is again round.
  int parts() const { return mantissa == 2 ? 4 : 5; }
};

Steps round_steps(Interval range, int wanted) {
  const int target = std::clamp(wanted, 2, 100);
  const double raw = (range.high - range.low) / (target - 1);
  const int decade = static_cast<int>(std::floor(std::log10(raw)));
  const std::array<std::pair<int, int>, 5> candidates{{{1, decade}, {2, decade}, {25, decade - 1}, {5, decade}, {1, decade + 1}}};
  Steps best{};
  double best_miss = largest;
  for (const auto& [mantissa, exponent] : candidates) {
    Steps steps{mantissa, exponent, 0, 0};
    steps.first = std::floor(range.low / steps.step() + slack);
    steps.last = std::ceil(range.high / steps.step() - slack);
    const double miss = std::abs(steps.count() - target);
    if (miss < best_miss) {  // of equals the smaller step: more ticks
      best = steps;
      best_miss = miss;
    }
  }
  return best;
}

std::string superscript(int number) {
  static constexpr std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string with_minus_sign(const std::string& number) { return number.starts_with('-') ? "−" + number.substr(1) : number; }

int decade_of(double magnitude) { return magnitude < smallest ? 0 : static_cast<int>(std::floor(std::log10(magnitude) + slack)); }

// Labels may have so many digits before a common offset is split off.
constexpr int label_digits = 5;

double common_offset(Interval range, int wanted) {
  const Steps steps = round_steps(range, wanted);
  const double magnitude = std::max(std::abs(range.low), std::abs(range.high));
  if (decade_of(magnitude) - steps.exponent + 1 <= label_digits) return 0;
  const int exponent = static_cast<int>(std::ceil(std::log10(range.high - range.low)));
  const double unit = Steps::scaled(1, exponent);
  return Steps::scaled(std::round((range.low / 2 + range.high / 2) / unit), exponent);
}

// Plain numbers from 0.01 to 9999; outside, a power of a thousand is taken out.
int common_exponent(double magnitude) {
  if (magnitude < smallest || (magnitude >= 0.0099 && magnitude < 10000)) return 0;
  return 3 * static_cast<int>(std::floor(decade_of(magnitude) / 3.0));
}

}  // namespace

Interval widened(Interval interval) {
  double low = std::clamp(std::min(interval.low, interval.high), -largest, largest);
  double high = std::clamp(std::max(interval.low, interval.high), -largest, largest);
  if (!std::isfinite(low) || !std::isfinite(high)) return {0, 1};
  const double magnitude = std::max(std::abs(low), std::abs(high));
  if (magnitude < smallest) return {-1, 1};
  if (high - low > rounding * magnitude) return {low, high};
  const double middle = low / 2 + high / 2;
  return {middle - 0.05 * magnitude, middle + 0.05 * magnitude};
}

std::vector<double> ticks(double low, double high, int wanted) {
  const Steps steps = round_steps(widened({low, high}), wanted);
  std::vector<double> values;
  for (double k = steps.first; k <= steps.last; ++k) values.push_back(steps.value(k));
  return values;
}

Scale make_scale(double low, double high, int wanted) {
  Scale scale{low, high, {}, {}, 0, 0};
  scale.offset = common_offset({low, high}, wanted);
  const Interval local{low - scale.offset, high - scale.offset};
  const Steps steps = round_steps(local, wanted);
  const double tolerance = slack * steps.step();
  const auto inside = [&](double value) { return value >= local.low - tolerance && value <= local.high + tolerance; };

  double magnitude = 0;
  for (double k = steps.first; k <= steps.last; ++k) {
    if (inside(steps.value(k))) magnitude = std::max(magnitude, std::abs(steps.value(k)));
  }
  scale.exponent = common_exponent(magnitude);
  const int decimals = std::max(0, scale.exponent - steps.exponent);
  for (double k = steps.first; k <= steps.last; ++k) {
    const double value = steps.value(k);
    if (!inside(value)) continue;
    const double shown = Steps::scaled(k * steps.mantissa, steps.exponent - scale.exponent);
    scale.major.push_back({value + scale.offset, with_minus_sign(fmt::format("{:.{}f}", shown, decimals))});
  }
  for (double k = steps.first; k < steps.last; ++k) {
    for (int part = 1; part < steps.parts(); ++part) {
      const double value = steps.value(k) + steps.step() * part / steps.parts();
      if (inside(value)) scale.minor.push_back(value + scale.offset);
    }
  }
  return scale;
}

std::string typeset(double value, int significant) {
  std::string text = significant > 0 ? fmt::format("{:.{}g}", value, significant) : fmt::format("{}", value);
  if (const auto e = text.find('e'); e != std::string::npos) {
    const int exponent = std::atoi(text.c_str() + e + 1);
    text = text.substr(0, e) + "×10" + superscript(exponent);
  }
  return with_minus_sign(text);
}

std::string axis_title(const Axis& axis, const Scale& scale) {
  std::string title = axis.label;
  if (scale.offset != 0) title += (scale.offset < 0 ? " + " : " − ") + typeset(std::abs(scale.offset));
  std::string unit = scale.exponent == 0 ? "" : "10" + superscript(scale.exponent);
  if (!axis.unit.empty()) unit += (unit.empty() ? "" : " ") + axis.unit;
  if (!unit.empty()) title += (title.empty() ? "[" : " [") + unit + "]";
  return title;
}

}  // namespace pmreport::figure
