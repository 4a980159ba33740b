// Parts and holes of what a grid accepts, and the sheet that a pose lies on.
#pragma once

#include <core/scan/grid.hpp>

#include <cstdint>
#include <vector>

namespace pmreport::scan {

struct Components {
  std::vector<std::uint64_t> parts;  // points of each part of the accepted points, largest first; neighbours differ by one step on one axis
  std::vector<std::uint64_t> holes;  // refused points that are shut in: no way to the rim of the grid by such steps
};
// Of points with at least `need` accepted orientations. `counts`: the points' last axis fastest.
Components components(const std::vector<std::size_t>& counts, const std::vector<std::uint32_t>& accepted_at, std::uint32_t need = 1);

struct Sheet {
  std::uint64_t poses = 0;      // connected with the start by single grid steps over accepted poses with the sign of the start
  std::uint64_t connected = 0;  // without regard to the sign
  int sign = 0;                 // at the start; 0: the start is not accepted, or has none
};
// Needs counts with poses that were kept. Axes of a step: point axes, then, where the orientations are a product of values, `turned_counts`
// of them. `start`: number of the pose.
Sheet sheet_of(const std::vector<std::size_t>& counts, const std::vector<std::size_t>& turned_counts, const GridCounts& kept,
               std::uint64_t start);

}  // namespace pmreport::scan
