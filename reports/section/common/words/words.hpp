// Numbers, symbols and sentences as every section writes them.
#pragma once

#include <core/text/units.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace pmreport::section {

// "812.4 mm": an SI value in the unit that reads best at its size.
std::string show(double si, std::string_view unit, int digits = 4);
std::string show(double si, const DisplayUnit& in, int digits = 4);  // in a unit that is chosen already
// Two values that are told beside each other, in one unit and with the digits that set them apart: "1200.06 mm", "1200.00 mm".
struct Apart {
  std::string value, beside;
};
Apart show_apart(double value, double beside, std::string_view unit, int digits = 4);
Apart show_apart(double value, double beside, const DisplayUnit& in, int digits = 4);
// "1.32 s", with as many decimals as the samples of the motion need.
std::string show_time(const Analysis& a, int sample);
// "l₁", "α", "ρ₃": a name of the program as a symbol of the field.
std::string symbol(std::string_view name);
// A symbol with a dot or two over its first letter, for its rate or acceleration: "l̇₁".
std::string with_dots(const std::string& symbol, int dots);
// "F₃" for the force of l3 or rho3, "τ₁" for the torque of theta1, "Fx" for the force of lx, "P₃" for a power; where that would name two of
// them, "F l3".
enum class Effort { force, power };
std::string effort_symbol(const Topology& t, const Actuator& actuator, Effort what = Effort::force);
// A number with a true minus sign, for tables and sentences.
std::string typeset(std::string number);
// "kg·m²", "°": a unit as it is set in tables.
std::string typographic(std::string_view unit);
std::string plural(int n, const std::string& singular, const std::string& many = "");  // "1 sample", "12 samples"

inline constexpr std::size_t told_one_by_one = 3;  // of a sort; of more the first, and how many more
// "t = 0.3 s", "t = 0.3 s to 0.42 s": from one sample to another.
std::string span_of(const Analysis& a, int first, int last);
// "l1 to l6", "A1, A3 and B2": in order, those that count on told by their ends.
std::string names_of(std::vector<std::string> names);

// "t = 3.1 s to 3.4 s: the mechanism cannot be assembled ...": each run of unreachable samples, many alike in one sentence.
std::vector<std::string> reach_sentences(const Analysis& a);
// Why nothing could be computed at any sample, or at too few: "no sample can be assembled (the feeler is too short)".
std::string why_nothing(const Analysis& a);

}  // namespace pmreport::section
