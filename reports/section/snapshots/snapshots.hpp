// Section `snapshots`: pictures of the mechanism at times of the motion.
#pragma once

#include <reports/section/common/stage.hpp>
#include <reports/section/kind.hpp>

#include <optional>
#include <vector>

namespace pmreport::section {

struct SnapshotsOptions : scenario::Options, Look {
  std::vector<double> times;   // [s]
  std::optional<int> overlay;  // poses laid over one another in one more picture; 0: no such picture. None: by the motion
};

// `number`: of the section among its kind.
Result snapshots_section(const Analysis& a, const SnapshotsOptions& r, const Stage& stage, const Progress& progress, int number);

}  // namespace pmreport::section
