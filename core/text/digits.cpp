#include <core/text/digits.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/text/units.hpp>

namespace pmreport {
namespace {

constexpr int digits_of_a_double = 15;          // that survive the way to text and back
constexpr double least = 1e-3, greatest = 1e9;  // beyond, decimals are no way to write a number

int decade_of(double magnitude) { return static_cast<int>(std::floor(std::log10(magnitude))); }

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.front() == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

// Zeros at the end that all of them have say nothing.
void drop_common_zeros(std::vector<std::string>& texts) {
  const auto all_end_with = [&](char c) {
    return std::all_of(texts.begin(), texts.end(), [c](const std::string& t) { return t.back() == c; });
  };
  const auto drop = [&] {
    for (std::string& t : texts) t.pop_back();
  };
  while (all_end_with('0')) drop();
  if (all_end_with('.')) drop();
}

}  // namespace

std::vector<std::string> format_together(const std::vector<double>& values, int digits, int of_span, double rounding) {
  double low = 0, high = 0;
  bool any = false;
  for (const double x : values) {
    if (!std::isfinite(x)) continue;
    low = any ? std::min(low, x) : x;
    high = any ? std::max(high, x) : x;
    any = true;
  }
  const double largest = std::max(std::abs(low), std::abs(high)), span = high - low;
  const auto each = [&](int significant) {
    std::vector<std::string> out;
    for (const double x : values) out.push_back(format_number(x, significant));
    return out;
  };
  if (!(span > rounding) || !std::isfinite(span)) return each(digits);
  const int decade = decade_of(largest);
  const int decimals = std::min(of_span - 1 - decade_of(span), digits_of_a_double - 1 - decade);
  if (digits - 1 - decade >= decimals) return each(digits);
  if (largest < least || largest >= greatest) return each(decimals + 1 + decade);
  std::vector<std::string> out;
  for (const double x : values)
    if (std::isfinite(x)) out.push_back(fixed(x, std::max(decimals, 0)));
  if (decimals > 0) drop_common_zeros(out);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) out.insert(out.begin() + static_cast<std::ptrdiff_t>(i), format_number(values[i], digits));
  return out;
}

std::string format_outside(double seen, double low, double high, int digits) {
  constexpr int of_the_excess = 2;
  return format_together({seen, seen < low ? low : high}, digits, of_the_excess).front();
}

}  // namespace pmreport
