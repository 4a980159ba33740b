// Parts of a grid.
#pragma once

#include <core/scan/pose_set.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pmreport::scan {

// Points whose place on each axis lies from `begin` to before `end`.
struct Tile {
  std::vector<std::size_t> begin, end;

  std::size_t size() const {
    std::size_t n = 1;
    for (std::size_t a = 0; a < begin.size(); ++a) n *= end[a] - begin[a];
    return n;
  }
  // Of a point, by its places on the axes: its number within the tile, the last axis fastest.
  std::size_t place(std::span<const std::size_t> at) const {
    std::size_t n = 0;
    for (std::size_t a = 0; a < begin.size(); ++a) n = n * (end[a] - begin[a]) + at[a] - begin[a];
    return n;
  }
  std::size_t longest() const;  // the axis with most values
  bool operator==(const Tile&) const = default;
};

// A grid in tiles of one shape, but that those at the far ends may be smaller.
class Tiling {
 public:
  // The axis with most values is halved until a tile has no more than `most` points.
  Tiling(const Scan& scan, std::size_t most);

  std::size_t size() const { return size_; }
  Tile tile(std::size_t number) const;  // the last axis fastest

 private:
  std::vector<std::size_t> counts_, shape_, tiles_;
  std::size_t size_ = 1;
};

// f(k, places on the axes) of point k of a tile, the last axis fastest.
template <class F>
void each_point(const Tile& tile, F&& f) {
  std::vector<std::size_t> at = tile.begin;
  for (std::size_t k = 0, n = tile.size(); k < n; ++k) {
    f(k, std::span<const std::size_t>(at));
    for (std::size_t a = at.size(); a-- > 0;) {
      if (++at[a] < tile.end[a]) break;
      at[a] = tile.begin[a];
    }
  }
}

// One bit a pose in words that several threads may mark; none: nothing is marked.
struct PoseBits {
  std::uint64_t* accepted = nullptr;
  std::uint64_t* positive = nullptr;  // both or neither
  std::uint64_t* negative = nullptr;

  static void mark(std::uint64_t* words, std::size_t pose) {
    std::atomic_ref(words[pose / 64]).fetch_or(std::uint64_t{1} << pose % 64, std::memory_order_relaxed);
  }
};

}  // namespace pmreport::scan
