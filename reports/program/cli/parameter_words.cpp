#include <reports/program/cli/parameter_words.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace pmreport::program {

using mechanics::ParameterInfo;

namespace {

std::string with_unit(const std::string& number, const std::string& display) { return display.empty() ? number : number + " " + display; }

double factor_of(const std::string& display) { return parse_unit(display).value_or(Unit{"", 1, {}}).factor; }

double read(const std::string& number) {
  double out = 0;
  std::from_chars(number.data(), number.data() + number.size(), out);
  return out;
}

template <class One>
std::string default_of(const ParameterInfo& p, One one) {
  std::string out;
  for (const double x : p.defaults) out += (out.empty() ? "" : ", ") + one(x);
  return p.kind == PM_NUMBERS ? "[" + out + "]" : out;
}
const std::string& default_choice(const ParameterInfo& p) { return p.choices[static_cast<std::size_t>(p.defaults[0])]; }

}  // namespace

std::string quantity_in(double si, const std::string& display) {
  const double factor = factor_of(display), value = si / factor;
  // 205 * 0.001 is not 0.205: what the factor's rounding leaves is no reason for seventeen digits.
  constexpr double rounding = 2 * std::numeric_limits<double>::epsilon();
  for (int digits = 6; digits < 17; ++digits) {
    const std::string number = format_number(value, digits);
    if (std::abs(read(number) * factor - si) <= rounding * std::abs(si)) return with_unit(number, display);
  }
  return with_unit(format_number(value, 17), display);
}

std::string quantity_in_words(double si, const std::string& display) {
  return with_unit(format_number(si / factor_of(display), 6), display);
}

std::string display_unit_of(const std::string& si) { return si == "m" ? "mm" : si == "rad" ? "deg" : si; }

std::string toml_string(const std::string& text) {
  std::string out;
  for (const char c : printable(text)) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return "\"" + out + "\"";
}

std::string toml_key(const std::string& name) {
  const bool bare =
      !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == name.npos;
  return bare ? name : toml_string(name);
}

std::string default_in_toml(const ParameterInfo& p) {
  if (p.kind == PM_CHOICE) return toml_string(default_choice(p));
  return default_of(p, [&](double x) { return p.display.empty() ? quantity_in(x, "") : toml_string(quantity_in(x, p.display)); });
}

std::string default_in_words(const ParameterInfo& p) {
  if (p.kind == PM_CHOICE) return default_choice(p);
  return default_of(p, [&](double x) { return quantity_in_words(x, p.display); });
}

std::string range_in_words(const ParameterInfo& p) {
  if (p.kind != PM_CHOICE) return fmt::format("{} to {}", quantity_in_words(p.min, p.display), quantity_in_words(p.max, p.display));
  std::string out;
  for (const std::string& c : p.choices) out += (out.empty() ? "" : " | ") + c;
  return out;
}

}  // namespace pmreport::program
