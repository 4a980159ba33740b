// How far poses are from singular surfaces: along the motion, and over a map of two coordinates.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/analysis/study/pose_map.hpp>

#include <vector>

namespace pmreport::analysis {

// det G^, smallest singular value and condition of G^ at every sample; NaN without a pose.
struct AlongMotion {
  std::vector<double> determinant, smallest, condition;
  int worst = -1;  // sample of the smallest singular value; -1: none has a pose
};
AlongMotion along_motion(const Analysis& a, double length);

// det G^ and its smallest singular value, which takes the sign of det G^, over the map, row by row: `points` poses a row, the first
// coordinate rising along it. NaN: out of reach. `map.at` must be as long as the coordinates.
struct SingularityGrid {
  std::vector<double> determinant, smallest;
  int reachable = 0, negative = 0, singular = 0;  // poses; singular: det G is zero to rounding, and has no sign
};
SingularityGrid singularity_grid(const mechanics::Machine& m, const PoseMap& map, double length);

}  // namespace pmreport::analysis
