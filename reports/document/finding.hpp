// What a line of evidence found, in words.
#pragma once

#include <reports/document/report.hpp>

#include <string>

namespace pmreport::document {

// "measured 2.1 × 10⁻⁹ m, tolerance 1 × 10⁻⁹ m"; "has no value: no sample can be assembled; tolerance 1 × 10⁻⁹ m"; "not decided: at
// t = 1.2 s".
std::string finding(const Evidence& e);

// What it compares and, where nothing was compared, why; what fails or is not decided, and when.
std::string how_it_is_shown(const Evidence& e);

// Its value or tolerance as a table shows it; a dash where it is a statement that has none.
std::string number_shown(const Evidence& e, double number);

}  // namespace pmreport::document
