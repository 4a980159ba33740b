#include <core/scan/grid_size.hpp>

#include <core/scan/grid.hpp>
#include <core/scan/judge/walk.hpp>

#include <fmt/core.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

namespace pmreport::scan {

std::uint64_t poses_of(const Scan& scan) {
  constexpr std::uint64_t most = std::uint64_t{1} << 53;  // all of them are numbers that a double tells apart
  if (scan.orientation_count() > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error(fmt::format("{} orientations at each point; no more than {} can be counted", scan.orientation_count(),
                                        std::numeric_limits<std::uint32_t>::max()));
  std::uint64_t n = scan.orientation_count();
  for (const Axis& a : scan.points) {
    if (a.count == 0) throw std::length_error("a grid has at least one value on each axis; here is an axis with none");
    if (a.count > most / n)
      throw std::length_error("the grid has more than 2^53 poses, which cannot be counted; take fewer values on its axes");
    n *= a.count;
  }
  return n;
}

std::size_t memory_needed(const PoseSet& set, const Scan& scan, const GridOptions& options) {
  const std::uint64_t poses = poses_of(scan);
  std::size_t bytes = scan.point_count() * sizeof(std::uint32_t) * (set.late.every > 0 ? 2 : 1);
  if (options.keep_poses) bytes += (poses + 63) / 64 * sizeof(std::uint64_t) * (options.sign != nullptr ? 3 : 1);
  return bytes;
}

// Some tiles of equal distance from one another, each at a few orientations, pose by pose.
double seconds_needed(const PoseSet& set, const Scan& scan, const GridOptions& options) {
  constexpr std::size_t tiles = 8, orientations = 8, points = 4096;
  const std::uint64_t poses = poses_of(scan);
  const Plan plan(set, scan, options.reasons, options.sign);
  const Tiling tiling(scan, points);
  Walk walk(plan, false, [] {});
  std::uint64_t judged = 0;
  double seconds = 0;
  for (std::size_t t = 0; t < std::min(tiles, tiling.size()); ++t) {
    const std::size_t o = t * scan.orientation_count() / tiles;
    const Orientations some(plan, o, std::min(orientations, scan.orientation_count() - o));
    const Tile tile = tiling.tile(t * tiling.size() / std::min(tiles, tiling.size()));
    const auto start = std::chrono::steady_clock::now();
    judged += walk.run(tile, some, 0).tally.poses;
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  const double threads = static_cast<double>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  return seconds * static_cast<double>(poses) / static_cast<double>(judged) / threads;
}

}  // namespace pmreport::scan
