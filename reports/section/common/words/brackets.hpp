// Numbers of which two bounds are known, with the digits that these allow.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/text/units.hpp>

#include <string>
#include <string_view>

namespace pmreport::section {

using program::Bounds;

// Both ends times `per_si`, the lower rounded down and the upper up to the same decimals, one or two units of the last apart: "612.3841"
// and "612.3843". Alike where the two are one number to nine digits.
struct Ends {
  std::string low, high;
};
Ends ends_of(const Bounds& b, double per_si);

// "612.3841 … 612.3843 mm"; "550 mm" where both ends are that; "not known" where an end is infinite.
std::string bracket(const Bounds& b, std::string_view unit);
std::string bracket(const Bounds& b, const DisplayUnit& in);
// The same without its unit, for a column of them.
std::string bracket_number(const Bounds& b, double per_si);

// "t = 1.203142 s": a time that is known to lie within, with the decimals that this allows.
std::string instant_words(const Bounds& time);
// "from t = 3.12 s to 3.14 s", rounded outward; "at t = 3.12 s" where that is all.
std::string span_words(const Bounds& time);

// A number of cubic metres, or of whatever unit, as a reader has it: "0.1876 m³", "2.61 m²·rad"; and two that it lies between,
// rounded outward to a decimal more than sets them apart.
std::string show_volume(double si, const std::string& unit, int digits = 5);
std::string show_bracket(const Bounds& b, const std::string& unit);

}  // namespace pmreport::section
