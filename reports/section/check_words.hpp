// The numbers of a check in words: in the unit of its author, or where a bound bears none in the one that reads best.
#pragma once

#include <core/scenario/measured.hpp>
#include <reports/section/common/words/brackets.hpp>
#include <reports/section/common/words/words.hpp>

#include <optional>
#include <string>

namespace pmreport::section {

// The unit that an author wrote, to show numbers in; nothing where none was written.
std::optional<DisplayUnit> unit_written(const std::string& written_in);
// A bound [SI] as it was written, to the last digit that says something.
std::string written(double bound, const scenario::Check& c);
// What was measured and a bound beside it [SI].
Apart measured_words(double value, double bound, const scenario::Check& c);
// What a proof knows of the number [SI]: "612.3841 … 612.3843 mm".
std::string known_words(const Bounds& b, const scenario::Check& c);
// What a section knows of it from both sides [SI]: "0.1876 to 0.1879 m³".
std::string bounds_words(const Bounds& b, const scenario::Check& c);

}  // namespace pmreport::section
