// What holds for every file in the place of a report's results.json, or of a data/*.csv beside it: it is refused with a reason, or what was
// read agrees with itself.
#pragma once

#include <reports/compare/comparison.hpp>
#include <reports/compare/data_names.hpp>
#include <reports/compare/spreadsheet.hpp>
#include <tests/fuzz/scratch.hpp>

#include <string>

namespace fuzz {

inline std::string broken_by_refusal(const std::string& sentence) {
  if (sentence.empty()) return "a refusal without a reason";
  return has_control(sentence, "") ? "a control character in a sentence to the user" : "";
}

inline std::string broken_by_results(const std::string& bytes) {
  using namespace pmreport::compare;
  std::vector<Results> two(2);
  try {
    two[0] = read_results(bytes, "a.json");
    two[1] = read_results(bytes, "b.json");
    (void)data_names(bytes, "a.json");
  } catch (const InputError& e) {
    if (const std::string broken = broken_by_refusal(e.what()); !broken.empty()) return broken;
  }
  try {
    if (const auto curves = read_curves(bytes, "displacement")) {
      if (!is_a_course(curves->time)) return "a course of time that goes back";
      if (curves->columns.size() != curves->headings.size()) return "curves without a heading";
      for (const auto& column : curves->columns)
        if (column.size() != curves->time.size()) return "a curve of another length than its time";
      for (Results& r : two) r.curves.push_back(*curves);
    }
  } catch (const SpreadsheetError& e) {
    if (const std::string broken = broken_by_refusal(e.what()); !broken.empty()) return broken;
  }
  if (two[0].values.size() != two[1].values.size()) return {};  // the second was not read, for the first was refused
  const Comparison comparison = pmreport::compare::compare(two, {});
  for (const ValueRow& row : comparison.values)
    if (row.differs || !row.everywhere) return "a value that is not itself";
  for (const JudgementRow& row : comparison.judgements)
    if (row.differs || !row.everywhere) return "a judgement that is not itself";
  for (const CurveRow& row : comparison.curves)
    if (row.differs || row.gap || !row.everywhere) return "a curve that is not itself";
  return comparison.agree ? "" : "a report that differs from itself";
}

}  // namespace fuzz
