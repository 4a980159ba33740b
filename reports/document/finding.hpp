// What a line of evidence found, in words.
#pragma once

#include <reports/document/report.hpp>

#include <string>

namespace pmreport::document {

// "measured 2.1 × 10⁻⁹ m, tolerance 1 × 10⁻⁹ m"; "has no value: no sample can be assembled; tolerance 1 × 10⁻⁹ m".
std::string finding(const Evidence& e);

// What it compares and, where nothing was compared, why.
std::string how_it_is_shown(const Evidence& e);

}  // namespace pmreport::document
