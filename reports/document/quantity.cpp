#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <reports/document/quantity.hpp>

namespace pmreport::document {

namespace {

std::string superscript(std::string_view digits) {
  static constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  for (const char c : digits) out += c == '-' ? "⁻" : raised[c - '0'];
  return out;
}

std::string power_of_ten(double size) {
  const std::string text = fmt::format("{:.1e}", size);
  const std::size_t e = text.find('e');
  int exponent = 0;
  const char* first = text.data() + e + 1;
  std::from_chars(*first == '+' ? first + 1 : first, text.data() + text.size(), exponent);
  double shown = 0;
  std::from_chars(text.data(), text.data() + text.size(), shown);
  std::string mantissa = text.substr(0, e);
  if (shown == size && mantissa.ends_with(".0")) mantissa.resize(mantissa.size() - 2);
  return mantissa + " × 10" + superscript(std::to_string(exponent));
}

}  // namespace

std::string rounded(double value) {
  if (!std::isfinite(value)) return "not computed";
  if (value == 0) return "0";
  const double size = std::abs(value);
  const std::string sign = value < 0 ? "−" : "";
  if (size >= 1e-3 && size < 999.5) return sign + fmt::format("{:.3g}", size);
  if (size >= 999.5 && size < 9999.5) return sign + fmt::format("{:.0f}", size);
  return sign + power_of_ten(size);
}

std::string unit_text(std::string_view si) {
  std::string out;
  for (std::size_t i = 0; i < si.size(); ++i) {
    if (si[i] == '*') {
      out += "·";
    } else if (si[i] == '^') {
      const std::size_t end = std::min(si.find_first_not_of("-0123456789", i + 1), si.size());
      out += superscript(si.substr(i + 1, end - i - 1));
      i = end - 1;
    } else {
      out += si[i];
    }
  }
  return out;
}

std::string rounded(double value, std::string_view unit) {
  const std::string number = rounded(value);
  return unit.empty() || !std::isfinite(value) ? number : number + " " + unit_text(unit);
}

}  // namespace pmreport::document
