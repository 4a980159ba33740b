// A grid cut in chunks: what is counted of each, and how all of them are put together.
#pragma once

#include <core/scan/grid.hpp>
#include <core/scan/judge/groups.hpp>
#include <core/scan/judge/tile.hpp>
#include <core/scan/judge/walk.hpp>

#include <tbb/enumerable_thread_specific.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace pmreport::scan {

// A step is a tile at one group of orientations, group after group; a chunk is some steps that follow one another. Both are of a size that
// the set and the scan alone decide. What is found are sums of whole numbers, so who counts what does not matter.
class GridChunks {
 public:
  GridChunks(const PoseSet& set, const Scan& scan, const GridOptions& options, std::function<void()> stop_if_asked);

  std::size_t size() const { return (steps() + steps_of_a_chunk_ - 1) / steps_of_a_chunk_; }
  std::uint64_t form() const;  // a hash of the order in which answers are written
  // Called by several threads at once.
  chunks::Bytes compute(std::size_t chunk);
  // Adds them to the counts. Throws chunks::NotReadable.
  void take(std::size_t chunk, std::span<const std::byte> answers);
  GridCounts& counts() { return out_; }

 private:
  struct Tiles {  // at one group, one after another
    std::size_t group, first, end;
  };
  std::size_t steps() const { return groups_.size() * tiling_.size(); }
  std::vector<Tiles> tiles_of(std::size_t chunk) const;
  void count(const Tiles& tiles, const Orientations& orientations, std::span<const int> parts, Found& sums, chunks::Writer& out);
  void add_counts(const Tile& tile, chunks::Reader& in, std::vector<std::uint32_t>& to);
  void add_bits(const Tile& tile, std::size_t group, chunks::Reader& in, std::vector<std::uint64_t>& to);

  const Scan& scan_;
  const Plan plan_;
  const std::uint64_t poses_of_a_tile_;  // no more than so many, but that there is a least number of points
  const Tiling tiling_;
  Groups groups_;
  std::size_t steps_of_a_chunk_;
  tbb::enumerable_thread_specific<Walk> walks_;
  std::vector<std::uint32_t> counts_of_tile_;  // what is taken, before it is added
  std::vector<std::uint64_t> bits_of_tile_;
  GridCounts out_;
};

}  // namespace pmreport::scan
