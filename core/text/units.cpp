#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <core/text/units.hpp>
#include <numbers>

namespace pmreport {
namespace {

constexpr Dimension plain{}, length{1, 0, 0, 0}, mass{0, 1, 0, 0}, time{0, 0, 1, 0}, angle{0, 0, 0, 1};
constexpr Dimension frequency{0, 0, -1, 0}, angular_velocity{0, 0, -1, 1};
// A moment is force times lever arm and holds no angle; so work, which is moment times angle in radians, cannot be told from it.
constexpr Dimension force{1, 1, -2, 0}, moment{2, 1, -2, 0}, pressure{-1, 1, -2, 0}, power{2, 1, -3, 0};

struct Row {
  std::string_view symbol;
  double factor;
  Dimension dimension;
};
constexpr double turn = 2 * std::numbers::pi;
constexpr double pound = 0.45359237, standard_gravity = 9.80665;  // [kg], [m/s^2]: exact, by agreement
constexpr Row table[] = {
    {"m", 1, length},
    {"mm", 1e-3, length},
    {"um", 1e-6, length},
    {"µm", 1e-6, length},  // U+00B5, the micro sign
    {"μm", 1e-6, length},  // U+03BC, the Greek letter, which keyboards give
    {"nm", 1e-9, length},
    {"cm", 1e-2, length},
    {"km", 1e3, length},
    {"in", 0.0254, length},
    {"ft", 0.3048, length},
    {"rad", 1, angle},
    {"mrad", 1e-3, angle},
    {"nrad", 1e-9, angle},
    {"urad", 1e-6, angle},
    {"µrad", 1e-6, angle},
    {"μrad", 1e-6, angle},
    {"arcsec", turn / 1296000, angle},
    {"deg", turn / 360, angle},
    {"°", turn / 360, angle},
    {"s", 1, time},
    {"ms", 1e-3, time},
    {"min", 60, time},
    {"h", 3600, time},
    {"Hz", 1, frequency},
    {"rpm", turn / 60, angular_velocity},
    {"N", 1, force},
    {"kN", 1e3, force},
    {"MN", 1e6, force},
    {"GN", 1e9, force},
    {"mN", 1e-3, force},
    {"lbf", pound* standard_gravity, force},
    {"kgf", standard_gravity, force},
    {"Nm", 1, moment},
    {"Nmm", 1e-3, moment},
    {"kNm", 1e3, moment},
    {"kg", 1, mass},
    {"g", 1e-3, mass},
    {"t", 1e3, mass},
    {"lb", pound, mass},
    {"Pa", 1, pressure},
    {"MPa", 1e6, pressure},
    {"GPa", 1e9, pressure},
    {"J", 1, moment},
    {"W", 1, power},
    {"kW", 1e3, power},
    {"%", 1e-2, plain},
};

struct Name {
  Dimension dimension;
  const char *name, *example;
};
constexpr Name names[] = {
    {plain, "a plain number", "0.5"},
    {length, "a length", "250 mm"},
    {angle, "an angle", "5 deg"},
    {time, "a time", "2.5 s"},
    {mass, "a mass", "8 kg"},
    {{1, 0, -1, 0}, "a velocity", "20 mm/s"},
    {angular_velocity, "an angular velocity", "30 deg/s"},
    {{1, 0, -2, 0}, "an acceleration", "9.81 m/s^2"},
    {{0, 0, -2, 1}, "an angular acceleration", "10 deg/s^2"},
    {force, "a force", "10 N"},
    {moment, "a moment", "10 N*m"},
    {{2, 1, 0, 0}, "a moment of inertia", "0.03 kg*m^2"},
    {frequency, "a frequency", "2 Hz"},
    {{2, 0, 0, 0}, "an area", "20 mm^2"},
    {{3, 0, 0, 0}, "a volume", "20 mm^3"},
    {{0, 1, -2, 0}, "a stiffness", "100 N/mm"},
    {{0, -1, 2, 0}, "a compliance", "1 um/N"},
    {{-1, -1, 2, 0}, "an inverse force", "1 1/MN"},
    {{-2, -1, 2, 1}, "an angular compliance", "1 urad/N/m"},
    {{2, 1, -2, -1}, "an angular stiffness", "100 N*m/rad"},
    {pressure, "a pressure", "210 GPa"},
    {power, "a power", "50 W"},
    {{-3, 1, 0, 0}, "a density", "7850 kg/m^3"},
};

// "m^2*kg/s": numerator first, "1/s" without one.
std::string composed(const Dimension& d) {
  const std::pair<const char*, int> parts[] = {{"m", d.length}, {"kg", d.mass}, {"rad", d.angle}, {"s", d.time}};
  std::string out;
  for (const auto& [symbol, exponent] : parts)
    if (exponent > 0) out += fmt::format("{}{}{}", out.empty() ? "" : "*", symbol, exponent > 1 ? fmt::format("^{}", exponent) : "");
  if (out.empty()) out = "1";
  for (const auto& [symbol, exponent] : parts)
    if (exponent < 0) out += fmt::format("/{}{}", symbol, exponent < -1 ? fmt::format("^{}", -exponent) : "");
  return out;
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && s.front() == ' ') s.remove_prefix(1);
  while (!s.empty() && s.back() == ' ') s.remove_suffix(1);
  return s;
}

// One factor, "mm" or "s^2" or "1", to the power of `sign`.
bool multiply(Unit& unit, std::string_view factor, int sign) {
  factor = trimmed(factor);
  int exponent = 1;
  if (const auto hat = factor.find('^'); hat != std::string_view::npos) {
    const std::string_view digits = trimmed(factor.substr(hat + 1));
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || end != digits.data() + digits.size() || std::abs(exponent) > 9) return false;
    factor = trimmed(factor.substr(0, hat));
  }
  if (factor == "1") return exponent == 1;
  for (const Row& row : table) {
    if (row.symbol != factor) continue;
    unit.factor *= std::pow(row.factor, sign * exponent);
    for (int i = 0; i < std::abs(exponent); ++i)
      unit.dimension = (sign * exponent > 0) ? unit.dimension * row.dimension : unit.dimension / row.dimension;
    return true;
  }
  return false;
}

// As a typesetter writes a unit: N·m, m/s², rad/(N·m).
std::string typographic(std::string_view unit) {
  if (const auto first = unit.find('/'); first != std::string_view::npos && unit.find('/', first + 1) != std::string_view::npos) {
    std::string below(unit.substr(first + 1));
    std::ranges::replace(below, '/', '*');
    return typographic(unit.substr(0, first)) + "/(" + typographic(below) + ")";
  }
  static constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  bool raised = false;
  for (const char c : unit) {
    if (c == '^')
      raised = true;
    else if (raised && c == '-')
      out += "⁻";
    else if (raised && c >= '0' && c <= '9')
      out += digits[static_cast<std::size_t>(c - '0')];
    else {
      raised = false;
      out += c == '*' ? "·" : std::string(1, c);
    }
  }
  return out;
}

// From `from` upward (SI) a quantity reads best in `unit`.
struct Step {
  double from;
  const char* unit;
};
std::vector<Step> steps(std::string_view si) {
  if (si == "m") return {{0, "mm"}, {1e-12, "nm"}, {1e-7, "µm"}, {1e-4, "mm"}, {10, "m"}};
  if (si == "m/s") return {{0, "mm/s"}, {1e-12, "µm/s"}, {1e-4, "mm/s"}, {10, "m/s"}};
  if (si == "m/s^2") return {{0, "mm/s^2"}, {10, "m/s^2"}};
  if (si == "rad") return {{0, "°"}, {1e-12, "µrad"}, {1e-4, "°"}};
  if (si == "rad/s") return {{0, "°/s"}};
  if (si == "rad/s^2") return {{0, "°/s^2"}};
  if (si == "N") return {{0, "N"}, {1e-12, "mN"}, {0.1, "N"}, {1e4, "kN"}};
  if (si == "N*m") return {{0, "N*m"}, {1e-12, "N*mm"}, {0.1, "N*m"}, {1e4, "kN*m"}};
  if (si == "N/m") return {{0, "N/mm"}, {1e5, "N/µm"}};
  if (si == "m/N") return {{0, "nm/N"}, {1e-7, "µm/N"}, {1e-4, "mm/N"}};
  if (si == "1/N") return {{0, "1/GN"}, {1e-8, "1/MN"}, {1e-4, "1/kN"}};
  if (si == "rad/N/m") return {{0, "nrad/N/m"}, {1e-7, "µrad/N/m"}, {1e-4, "mrad/N/m"}};
  if (si == "Pa") return {{0, "Pa"}, {1e4, "MPa"}, {1e10, "GPa"}};
  if (si == "W") return {{0, "W"}, {1e4, "kW"}};
  return {};
}

}  // namespace

std::optional<Unit> parse_unit(std::string_view text) {
  Unit unit{std::string(trimmed(text)), 1, {}};
  if (unit.symbol.empty()) return unit;
  if (text.size() > 100) return std::nullopt;
  std::string_view rest = text;
  for (int sign = 1;;) {
    const auto end = rest.find_first_of("*/");
    if (!multiply(unit, rest.substr(0, end), sign)) return std::nullopt;
    if (end == std::string_view::npos) return unit;
    sign = rest[end] == '*' ? 1 : -1;
    rest.remove_prefix(end + 1);
  }
}

std::string unit_at_end(std::string_view quantity, const Dimension& dimension) {
  const auto of_word = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t i = 0; i < quantity.size(); ++i) {
    if (i > 0 && of_word(quantity[i - 1])) continue;
    const auto unit = parse_unit(quantity.substr(i));
    if (unit && unit->dimension == dimension && !unit->symbol.empty() && unit->symbol != "1") return unit->symbol;
  }
  return {};
}

std::string unknown_unit_in(std::string_view text) {
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of("*/"), text.size());
    const std::string_view symbol = trimmed(text.substr(0, std::min(text.find('^'), end)));
    const bool a_word = symbol.find_first_of("0123456789") == std::string_view::npos;
    if (!symbol.empty() && a_word && !parse_unit(symbol)) return std::string(symbol);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

std::vector<std::string> unit_symbols() {
  std::vector<std::string> out;
  for (const Row& row : table) out.emplace_back(row.symbol);
  return out;
}

std::string name_of(const Dimension& d) {
  for (const Name& n : names)
    if (n.dimension == d) return n.name;
  return composed(d);
}

std::string example_of(const Dimension& d) {
  for (const Name& n : names)
    if (n.dimension == d) return n.example;
  return "1 " + composed(d);
}

DisplayUnit display_unit(std::string_view si, double largest) {
  const char* best = nullptr;
  for (const Step& step : steps(si))
    if (std::abs(largest) >= step.from || best == nullptr) best = step.unit;
  if (best == nullptr) return {typographic(si), 1};
  return {typographic(best), 1 / parse_unit(best)->factor};
}

std::string format_number(double value, int digits) {
  if (!std::isfinite(value)) return "—";
  if (value == 0) return "0";
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const auto e = scientific.find('e');
  int exponent = 0;
  const char* first = scientific.data() + e + (scientific[e + 1] == '+' ? 2 : 1);
  std::from_chars(first, scientific.data() + scientific.size(), exponent);
  const auto without_idle_zeros = [](std::string s) {
    if (s.find('.') == std::string::npos) return s;
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
    return s;
  };
  if (exponent < -3 || exponent >= std::max(digits, 6)) return fmt::format("{}e{}", without_idle_zeros(scientific.substr(0, e)), exponent);
  double rounded = 0;
  std::from_chars(scientific.data(), scientific.data() + scientific.size(), rounded);
  return without_idle_zeros(fmt::format("{:.{}f}", rounded, std::max(0, digits - 1 - exponent)));
}

}  // namespace pmreport
