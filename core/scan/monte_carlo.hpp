// The volume by random poses, with its uncertainty.
#pragma once

#include <core/chunks/sharing.hpp>
#include <core/scan/pose_set.hpp>
#include <core/scan/tally.hpp>

#include <cstdint>

namespace pmreport::scan {

struct MonteCarloOptions {
  std::uint64_t poses = 1'000'000;
  std::uint64_t seed = 1;
  bool reasons = true;
};

// Pose k has numbers that are a function of seed, k and the axis alone: the same however the work is shared.
struct Estimate {
  // Of points. With orientations a point counts as accepted where at least `need` of them are, as on a limit where fewer would be without
  // those that rounding decides; what refuses is counted of all its poses.
  Tally tally;
  double share = 0, low = 0, high = 0;  // of the scanned range: accepted, and its 95 % interval (Wilson 1927)
};
// `work`: as of count_grid. Throws what chunks::run throws; std::invalid_argument: no poses; `need` is none, or more than there are
// orientations.
Estimate monte_carlo(const PoseSet& set, const Scan& scan, std::size_t need, const MonteCarloOptions& options, const Watch& watch = {},
                     const chunks::Work& work = {}, const chunks::Sharing& sharing = {});

}  // namespace pmreport::scan
