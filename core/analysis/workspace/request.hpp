// What a workspace section asks.
#pragma once

#include <core/mechanics/workspace/pose_limits.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::analysis {

enum class ScanMethod { proof, grid, monte_carlo };

struct ScanRange {
  int coordinate = 0;
  double from = 0, to = 0;  // SI
  std::size_t count = 0;    // 0: not given, a proof needs none
};

struct WorkspaceRequest {
  std::string name = "workspace";                      // of what a long scan keeps on disk
  std::vector<ScanMethod> methods{ScanMethod::proof};  // each once; the first gives the volume that is told
  std::vector<ScanRange> scan;                         // one coordinate or more
  Eigen::VectorXd at;                                  // coordinates that are not scanned; NaN, or of no size: home
  // The point that is scanned in place of the platform's reference point, in the platform's axes [m]: coordinates of the place are its.
  std::optional<Eigen::Vector3d> tool;
  mechanics::LimitChoice limits;
  // Orientations that are tried at each point: the product of ranges, or a list of poses of which only `turned` counts.
  std::vector<ScanRange> orientations;
  std::vector<Eigen::VectorXd> orientation_list;
  std::vector<int> turned;              // coordinates that the orientations set
  std::vector<std::uint64_t> at_least;  // orientations that must be accepted at a point, each an answer of its own; empty: one, and all
  bool one_sheet = false;
  bool reasons = true;  // grid and Monte Carlo: which limits refuse
  double gap = 1e-3;    // proof
  double seconds = std::numeric_limits<double>::infinity();
  std::uint64_t poses = 1'000'000;  // Monte Carlo
  std::uint64_t seed = 1;
  bool safe = true;                 // safe box and ball around home
  std::vector<double> proportions;  // of the scanned coordinates for the safe box, SI; empty: those of the scanned ranges
};

// The unit of a volume over so many lengths and angles: "m^3", "m^2*rad", "rad".
std::string unit_of_volume(int metres, int radians);

}  // namespace pmreport::analysis
