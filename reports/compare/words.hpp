// What a comparison says, in sentences and tables; the same on standard output and on its page.
#pragma once

#include <reports/compare/comparison.hpp>

#include <string>
#include <vector>

namespace pmreport::compare {

std::string letter(std::size_t report);  // "A", "B", ...

// "They differ: 3 of 208 values and 1 of 37 verdicts. Not in both: 2 values. Numbers agree within a relative 1e-6 or ..."
std::string verdict(const Comparison& c);

// What to know before the tables are read: other mechanisms or scenarios, other programs, curves that are not there. A sentence each.
std::vector<std::string> remarks(const Comparison& c);

// Which letter is which report.
document::Table reports_table(const Comparison& c);

// Values, a table a section: of two reports those that differ, of more all that two or more share, with a column a report.
std::vector<document::Table> value_tables(const Comparison& c);
// Checks and evidence of which the verdict changed, or which not all reports have; at most one.
std::vector<document::Table> judgement_tables(const Comparison& c);
// Curves that differ; at most one.
std::vector<document::Table> curve_tables(const Comparison& c);
// Values and curves that one report alone has, a table a report.
std::vector<document::Table> lone_tables(const Comparison& c);

// One line a difference of a report, the second, from its baseline, the first: "displacement max(x) [m]: 0.12, in the baseline 0.13; ...".
std::vector<std::string> baseline_lines(const Comparison& c);

// All of it as plain text, columns aligned.
std::string to_text(const Comparison& c);

}  // namespace pmreport::compare
