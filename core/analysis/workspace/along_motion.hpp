// How far the poses of a motion stay from the boundary of a workspace.
#pragma once

#include <core/analysis/workspace/workspace.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>

#include <vector>

namespace pmreport::analysis {

// To first order: margin g with gradient g' over all coordinates is zero at a distance of
//     d = g / sqrt(sum over the coordinates (g'_i / s_i)^2),    s = 1 for lengths, L for angles
// lengths in m and angles times the characteristic length L. The least of all margins counts; negative: beyond. Exact for a plane boundary.
struct BoundaryDistance {
  std::vector<double> distance;  // [m] of each sample; NaN: no pose there
  std::vector<int> margin;       // which is nearest; -1: none
  int nearest = -1;              // sample of the least distance
};
BoundaryDistance distance_to_boundary(const Workspace& w, const mechanics::Machine& machine, const mechanics::Trajectory& trajectory,
                                      double length);

}  // namespace pmreport::analysis
