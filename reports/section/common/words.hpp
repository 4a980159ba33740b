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
// "1.32 s", with as many decimals as the samples of the motion need.
std::string show_time(const Analysis& a, int sample);
// "l₁", "α", "ρ₃": a name of the program as a symbol of the field.
std::string symbol(std::string_view name);
// A number with a true minus sign, for tables and sentences.
std::string typeset(std::string number);
// "kg·m²", "°": a unit as it is set in tables.
std::string typographic(std::string_view unit);
std::string plural(int n, const std::string& singular, const std::string& many = "");  // "1 sample", "12 samples"

// "t = 1.32 s to 2.10 s: l3 (length of limb 3) needs 812.4 mm, its stroke ends at 800.0 mm (worst at t = 1.64 s, 40 samples)".
std::string sentence(const Analysis& a, const LimitBreach& b);
// "t = 3.1 s to 3.4 s: cannot be assembled: ..." for each run of unreachable samples.
std::vector<std::string> reach_sentences(const Analysis& a);

}  // namespace pmreport::section
