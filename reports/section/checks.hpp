// Numbers of the report, and the gates over them.
#pragma once

#include <core/analysis/study/reduce.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>
#include <reports/section/common/words/proof_words.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using analysis::Number;
// A quantity among `values`, or columns reduced. `largest`: of a group the largest column counts, else the smallest.
Number measure(const Analysis& a, const scenario::Measured& m, const std::vector<document::Value>& values, bool largest = true);

// The [[check]] gates, and what every report demands: that the mechanism can be assembled, limits are kept, no singular surface is met.
// What a proof decides, of extremes too, it decides for every instant; the rest the samples do. By the proof of the run, or by another.
std::vector<document::Check> evaluate_checks(const Analysis& a, const std::vector<document::Value>& values);
std::vector<document::Check> evaluate_checks(const Analysis& a, const Proved& p, const std::vector<document::Value>& values);

}  // namespace pmreport::section
