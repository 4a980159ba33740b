// Section `comparison`: numbers of this report against published ones.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

// One line of a comparison with published values.
struct ComparisonRow {
  enum class Expected { nothing, reproduces, differs } expected = Expected::nothing;  // a gate, unless nothing
  std::string what;
  scenario::Measured here;
  double published = 0, tolerance = 0;  // SI
  std::string written_in;               // the unit of the published value, as its author has it; empty: none
  std::string source, note;             // may be empty
  int line = 0;
};

struct ComparisonOptions : scenario::Options {
  std::string source;  // of all rows; may be empty
  std::vector<ComparisonRow> rows;
};

// `values`: those of all other sections.
Result comparison_section(const Analysis& a, const ComparisonOptions& r, const std::vector<document::Value>& values);

}  // namespace pmreport::section
