// Parameters of a mechanism as a scenario would write them.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <string>

namespace pmreport::program {

// "400 mm", of a number in SI; a plain number where there is no unit. With as few digits as give this number, but for the rounding of the
// unit's factor, when a scenario is read.
std::string quantity_in(double si, const std::string& display);
// To six digits, for people.
std::string quantity_in_words(double si, const std::string& display);
// "mm" of "m", "deg" of "rad": what a reader expects; other units as they are.
std::string display_unit_of(const std::string& si);

// A text as a TOML string of one line.
std::string toml_string(const std::string& text);
std::string toml_key(const std::string& name);  // in quotes where it needs them

// As a TOML value: "\"400 mm\"", "[\"1 mm\", \"2 mm\"]", "\"steel\"".
std::string default_in_toml(const mechanics::ParameterInfo& p);
// For people: "400 mm", "[1 mm, 2 mm]", "steel".
std::string default_in_words(const mechanics::ParameterInfo& p);
// For people: "0 mm to 100000 mm", "out | in".
std::string range_in_words(const mechanics::ParameterInfo& p);

}  // namespace pmreport::program
