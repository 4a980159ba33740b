// The volume by random poses, with its uncertainty.
#pragma once

#include <core/scan/pose_set.hpp>
#include <core/scan/tally.hpp>

#include <cstdint>

namespace pmreport::scan {

struct MonteCarloOptions {
  std::uint64_t poses = 1'000'000;
  std::uint64_t seed = 1;
  bool reasons = true;
};

// Pose k has numbers that are a function of seed, k and the axis alone: the same for any number of threads.
struct Estimate {
  Tally tally;                          // of points; with orientations a point counts as accepted where at least `need` of them are
  double share = 0, low = 0, high = 0;  // of the scanned range: accepted, and its 95 % interval (Wilson 1927)
};
Estimate monte_carlo(const PoseSet& set, const Scan& scan, std::size_t need, const MonteCarloOptions& options, const Watch& watch = {});

}  // namespace pmreport::scan
