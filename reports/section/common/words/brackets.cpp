#include <reports/section/common/words/brackets.hpp>

#include <reports/section/common/words/words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

namespace {

constexpr int significant = 9;       // digits that are told at most
constexpr int decimals_of_time = 7;  // a tenth of a microsecond

// Without the zeros at the end that a number does not need.
std::string trimmed(std::string number) {
  if (number.find('.') == std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return number;
}

// With so many decimals, rounded to the side of `step`: down or up. What differs from a number of so many decimals by its own rounding
// alone is that number.
std::string rounded_to(double x, int decimals, double (*step)(double)) {
  const double power = std::pow(10.0, decimals), scaled = x * power, near = std::round(scaled);
  constexpr double of_rounding = 1e-15;
  const double whole = std::abs(scaled - near) <= of_rounding * std::abs(scaled) ? near : step(scaled);
  return typeset(fmt::format("{:.{}f}", (whole + 0.0) / power, decimals));
}

// Of a number of this size, known to `width`: so that a unit of the last decimal is no more than the width.
int decimals_for(double size, double width) {
  const int leading = size > 0 ? static_cast<int>(std::floor(std::log10(size))) : 0, most = significant - 1 - leading;
  const int wanted = width > 0 ? static_cast<int>(std::ceil(-std::log10(width))) : most;
  return std::clamp(std::min(wanted, most), 0, 15);
}

Ends rounded_outward(const Bounds& b, int decimals) {
  Ends out{rounded_to(b.low, decimals, std::floor), rounded_to(b.high, decimals, std::ceil)};
  if (out.low == out.high) out.low = out.high = trimmed(out.low);
  return out;
}

}  // namespace

Ends ends_of(const Bounds& b, double per_si) {
  const Bounds shown{b.low * per_si, b.high * per_si};
  return rounded_outward(shown, decimals_for(std::max(std::abs(shown.low), std::abs(shown.high)), shown.width()));
}

std::string bracket_number(const Bounds& b, double per_si) {
  if (!b.bounded()) return "not known";
  const Ends ends = ends_of(b, per_si);
  return ends.low == ends.high ? ends.low : ends.low + " … " + ends.high;
}

std::string bracket(const Bounds& b, std::string_view unit) {
  return bracket(b, display_unit(unit, std::max(std::abs(b.low), std::abs(b.high))));
}

std::string bracket(const Bounds& b, const DisplayUnit& in) {
  if (!b.bounded()) return "not known";
  return bracket_number(b, in.per_si) + (in.label.empty() || in.label == "°" ? in.label : " " + in.label);
}

std::string instant_words(const Bounds& time) {
  const int decimals =
      time.width() > 0 ? std::clamp(static_cast<int>(std::floor(-std::log10(time.width()))), 0, decimals_of_time) : decimals_of_time;
  const std::string number = fmt::format("{:.{}f}", time.middle(), decimals);
  return typeset(time.width() > 0 ? number : trimmed(number)) + " s";
}

std::string span_words(const Bounds& time) {
  // A tenth of the span, or finer: so that rounding outward makes it seem little longer than it is.
  const int decimals =
      time.width() > 0 ? std::clamp(static_cast<int>(std::ceil(1 - std::log10(time.width()))), 0, decimals_of_time) : decimals_of_time;
  const Ends ends = rounded_outward(time, decimals);
  return ends.low == ends.high ? fmt::format("at t = {} s", ends.low)
                               : fmt::format("from t = {} s to {} s", trimmed(ends.low), trimmed(ends.high));
}

std::string show_volume(double si, const std::string& unit, int digits) {
  return fmt::format("{} {}", typeset(format_number(si, digits)), typographic(unit));
}

std::string show_bracket(const Bounds& b, const std::string& unit) {
  const Ends ends = rounded_outward(b, decimals_for(std::max(std::abs(b.low), std::abs(b.high)), b.width()) + 1);
  return (ends.low == ends.high ? ends.low : ends.low + " to " + ends.high) + " " + typographic(unit);
}

}  // namespace pmreport::section
