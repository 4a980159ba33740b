#include <core/scan/grid.hpp>

#include <core/scan/grid_chunks.hpp>
#include <core/scan/grid_size.hpp>
#include <core/scan/meaning.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <new>
#include <numeric>
#include <stdexcept>

namespace pmreport::scan {

namespace {

// A point at which an orientation keeps all other margins and not those that must hold at every one has none that is accepted.
void demand_every(GridCounts& counts) {
  for (std::size_t k = 0; k < counts.by_others_at.size(); ++k)
    if (counts.accepted_at[k] < counts.by_others_at[k]) counts.accepted_at[k] = 0;
}

// Ends and centre of the accepted poses on each axis, from how many are accepted at each of its values: whole numbers, whose order does not
// matter.
void place_ends(const Scan& scan, GridCounts& counts) {
  const auto accepted = std::accumulate(counts.accepted_at.begin(), counts.accepted_at.end(), std::uint64_t{0});
  if (accepted == 0) return;
  std::vector<std::vector<std::uint64_t>> at;
  for (const Axis& a : scan.points) at.emplace_back(a.count, 0);
  each_point(Tile::whole(scan), [&](std::size_t k, std::span<const std::size_t> places) {
    if (counts.accepted_at[k] == 0) return;
    for (std::size_t a = 0; a < at.size(); ++a) at[a][places[a]] += counts.accepted_at[k];
  });
  for (std::size_t a = 0; a < at.size(); ++a) {
    const auto some = [](std::uint64_t n) { return n > 0; };
    const auto first = static_cast<std::size_t>(std::ranges::find_if(at[a], some) - at[a].begin());
    const auto last = at[a].size() - 1 - static_cast<std::size_t>(std::find_if(at[a].rbegin(), at[a].rend(), some) - at[a].rbegin());
    const Axis& axis = scan.points[a];
    counts.low.push_back(std::min(axis.value(first), axis.value(last)));
    counts.high.push_back(std::max(axis.value(first), axis.value(last)));
    double sum = 0;
    for (std::size_t k = first; k <= last; ++k) sum += static_cast<double>(at[a][k]) * axis.value(k);
    counts.centroid.push_back(sum / static_cast<double>(accepted));
  }
}

}  // namespace

GridCounts count_grid(const PoseSet& set, const Scan& scan, const GridOptions& options, const Watch& watch, const chunks::Work& work,
                      const chunks::Sharing& sharing) try {
  poses_of(scan);
  GridChunks grid(set, scan, options, watch.stop_if_asked);
  chunks::Meaning meaning;
  meaning << work.meaning << meaning_of(set, scan) << grid.form() << (options.sign != nullptr ? meaning_of(*options.sign) : 0);
  chunks::run(
      {work.name, meaning.value(), grid.size()}, sharing, [&](std::size_t chunk) { return grid.compute(chunk); },
      [&](std::size_t chunk, std::span<const std::byte> answers) { grid.take(chunk, answers); }, watch);
  demand_every(grid.counts());
  place_ends(scan, grid.counts());
  return std::move(grid.counts());
} catch (const std::bad_alloc&) {
  throw std::length_error(
      fmt::format("the counts of this grid need {} MiB of memory, which cannot be had; take fewer points, or do not keep "
                  "which poses are accepted",
                  memory_needed(set, scan, options) / (1024 * 1024)));
}

}  // namespace pmreport::scan
