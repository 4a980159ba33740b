#include <reports/program/cli/parameter_words.hpp>

#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

namespace pmreport::program {

using mechanics::ParameterInfo;

std::string quantity_in(double si, const std::string& display) {
  const std::optional<Unit> unit = parse_unit(display);
  const std::string number = format_number(unit ? si / unit->factor : si, 6);
  return display.empty() ? number : number + " " + display;
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

std::string default_in_toml(const ParameterInfo& p) {
  if (p.kind == PM_CHOICE) return toml_string(p.choices[static_cast<std::size_t>(p.defaults[0])]);
  std::string out;
  for (const double x : p.defaults) {
    const std::string number = quantity_in(x, p.display);
    out += (out.empty() ? "" : ", ") + (p.display.empty() ? number : "\"" + number + "\"");
  }
  return p.kind == PM_NUMBERS ? "[" + out + "]" : out;
}

std::string range_in_words(const ParameterInfo& p) {
  if (p.kind != PM_CHOICE) return fmt::format("{} to {}", quantity_in(p.min, p.display), quantity_in(p.max, p.display));
  std::string out;
  for (const std::string& c : p.choices) out += (out.empty() ? "" : " | ") + c;
  return out;
}

}  // namespace pmreport::program
