// Numbers of the report, and the gates over them.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <limits>
#include <string>
#include <vector>

namespace pmreport::section {

// One number of the report, and where it was found.
struct Number {
  double value = std::numeric_limits<double>::quiet_NaN();
  int sample = -1;     // -1: not at a single sample
  std::string column;  // of a group, the one that counts
};
// `largest`: of a group the largest column counts, else the smallest.
Number measure(const Analysis& a, const scenario::Measured& m, const std::vector<document::Value>& values, bool largest = true);

// The [[check]] gates, and what every report demands: samples in reach, limits kept, no singular surface crossed.
std::vector<document::Check> evaluate_checks(const Analysis& a, const std::vector<document::Value>& values);

}  // namespace pmreport::section
