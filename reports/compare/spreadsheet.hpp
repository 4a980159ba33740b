// data/*.csv as reports/document/data/csv.cpp writes it.
#pragma once

#include <reports/compare/results.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::compare {

// "line 3: expected 4 cells; seen 2".
class SpreadsheetError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whether these instants are a course of time: all of them numbers, none before the one in front of it.
bool is_a_course(const std::vector<double>& time);

// The curves of a file with a first column "t [s]" that is a course of time; nothing where it has another first column. Throws
// SpreadsheetError.
std::optional<Curves> read_curves(std::string_view csv, const std::string& section);

}  // namespace pmreport::compare
