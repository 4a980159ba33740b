// Section `snapshots`: pictures of the mechanism at times of the motion.
#pragma once

#include <reports/section/common/stage.hpp>
#include <reports/section/kind.hpp>

#include <vector>

namespace pmreport::section {

struct SnapshotsOptions : scenario::Options, Look {
  std::vector<double> times;  // [s]
  std::vector<View> views;
};

// `number`: of the section among its kind.
Result snapshots_section(const Analysis& a, const SnapshotsOptions& r, const Stage& stage, const Progress& progress, int number);

}  // namespace pmreport::section
