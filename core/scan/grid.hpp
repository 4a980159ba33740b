// Counts of a grid: every pose of it judged.
#pragma once

#include <core/chunks/sharing.hpp>
#include <core/scan/pose_set.hpp>
#include <core/scan/tally.hpp>

#include <cstdint>
#include <vector>

namespace pmreport::scan {

struct GridOptions {
  bool reasons = true;                     // which margins refuse; without, a block that one margin refuses is left at once
  bool prune = true;                       // blocks that intervals decide are not looked at pose by pose; the counts are the same
  const program::Program* sign = nullptr;  // its one output, of each accepted pose; inputs: the coordinates
  bool keep_poses = false;                 // which poses are accepted, and the sign at each
};

// Of the accepted poses, coordinates as the scan has them: point axes, then turned inputs.
struct GridCounts {
  Tally tally;
  std::vector<std::uint32_t> accepted_at;  // of each point, the last axis fastest: how many orientations
  // Of each point: how many but for margins that must hold at every orientation; empty where there are none. The tally and the poses that
  // are kept are of poses by themselves: they have those of a point at which another orientation fails such a margin.
  std::vector<std::uint32_t> by_others_at;
  std::vector<double> low, high, centroid;   // of each point axis; empty when none is accepted
  std::uint64_t positive = 0, negative = 0;  // accepted poses by the sign
  // One bit a pose, point by point, orientations fastest, the lowest bit of a word first; empty unless kept, and without a sign. A pose
  // whose sign is zero or no number is neither positive nor negative.
  std::vector<std::uint64_t> accepted_poses, positive_poses, negative_poses;
};

// Same counts for any number of threads, with and without pruning, and however the work is shared. `work`: its name, and the meaning of
// what decides the counts besides set, scan and options, as of what the late margins are made from; its count is left out. Throws what
// chunks::run throws; std::length_error: more poses than can be counted, or more memory than `memory_needed` tells for what is kept.
GridCounts count_grid(const PoseSet& set, const Scan& scan, const GridOptions& options, const Watch& watch = {},
                      const chunks::Work& work = {}, const chunks::Sharing& sharing = {});

std::size_t memory_needed(const PoseSet& set, const Scan& scan, const GridOptions& options);  // [bytes], without what the threads work in
// Seconds that the scan will take on this machine, from a small part of it: what intervals decide is not known beforehand, and is left out.
double seconds_needed(const PoseSet& set, const Scan& scan, const GridOptions& options);

}  // namespace pmreport::scan
