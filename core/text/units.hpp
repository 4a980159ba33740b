// Physical dimensions, the closed table of units, and how a quantity is shown.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport {

// Exponents of the base dimensions. The angle counts as one, so that 5 mm cannot pass for 5 degrees; functions such as sin take both an
// angle and a plain number.
struct Dimension {
  int length = 0, mass = 0, time = 0, angle = 0;
  auto operator<=>(const Dimension&) const = default;
  friend Dimension operator*(Dimension a, Dimension b) {
    return {a.length + b.length, a.mass + b.mass, a.time + b.time, a.angle + b.angle};
  }
  friend Dimension operator/(Dimension a, Dimension b) {
    return {a.length - b.length, a.mass - b.mass, a.time - b.time, a.angle - b.angle};
  }
};

struct Unit {
  std::string symbol;  // as written in a scenario: "mm", "N*m", "deg/s"
  double factor;       // value in this unit * factor = SI
  Dimension dimension;
};

// Parses a unit, "mm", "N*m", "kg*m^2", "m/s^2", "" (a plain number); nothing when it is none. SI prefixes are those of the table alone.
std::optional<Unit> parse_unit(std::string_view text);
// The unit at the end of a quantity: "rad/s" of "2*pi rad/s". Empty where there is none of the whole, as of "10 m / 4 s".
std::string unit_at_end(std::string_view quantity, const Dimension& dimension);
// Of what is no unit, the first symbol that the table does not have: "furlong" of "N*furlong"; empty when it is wrong in another way.
std::string unknown_unit_in(std::string_view text);
std::vector<std::string> unit_symbols();     // the table, for "did you mean"
std::string name_of(const Dimension& d);     // "a length", "an angle", "a force", "an angular velocity", "a plain number", else "m^2*kg/s"
std::string example_of(const Dimension& d);  // a quantity a user could write there: "250 mm", "5 deg", "10 N"

// The unit in which values of SI unit `si` up to `largest` read best: lengths in mm (nm, µm, m), angles in deg (µrad), forces in N or kN,
// rates and accelerations accordingly. `label` is typographic ("mm/s²", "°", "N·m"): for axes and tables. Data files stay SI.
struct DisplayUnit {
  std::string label;
  double per_si;  // SI value * per_si = displayed value
};
DisplayUnit display_unit(std::string_view si, double largest);

// A number with so many significant digits, without regard to locale: "812.4", "1.26e-4"; a true minus sign is not used.
std::string format_number(double value, int digits);

}  // namespace pmreport
