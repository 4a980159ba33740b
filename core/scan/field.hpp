// Margins over a small grid, for pictures: where each is zero, and by how much.
#pragma once

#include <core/scan/pose_set.hpp>

#include <vector>

namespace pmreport::scan {

// Over the point axes of the scan, the last fastest, at the orientation of `at`. Where the pose cannot be assembled all but the reach are
// NaN.
struct Field {
  std::vector<Axis> axes;
  std::vector<std::vector<double>> margins;  // of each margin one number a point
  std::vector<double> least() const;         // of each point: the least margin, over its own scale; negative: refused; NaN: no number
};
Field sample_field(const PoseSet& set, const Scan& scan);

}  // namespace pmreport::scan
