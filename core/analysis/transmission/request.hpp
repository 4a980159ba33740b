// What a section about transmission asks.
#pragma once

#include <core/analysis/workspace/request.hpp>
#include <core/scenario/section/key.hpp>

#include <optional>
#include <vector>

namespace pmreport::analysis {

// A grid of poses over which indices are averaged, each pose weighing alike.
struct GridRequest {
  std::vector<ScanRange> ranges;       // one coordinate or more, each with its count
  bool strokes = true, joints = true;  // limits that a pose must keep to count
};

struct TransmissionRequest : scenario::Options {
  std::optional<double> length;        // [m] makes moments comparable with forces; default: the characteristic length
  std::vector<Eigen::VectorXd> poses;  // coordinates, besides those of the motion
  std::optional<GridRequest> grid;
};

}  // namespace pmreport::analysis
