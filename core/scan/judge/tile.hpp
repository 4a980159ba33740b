// Parts of a grid.
#pragma once

#include <core/scan/pose_set.hpp>

#include <cstddef>
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
  static Tile whole(const Scan& scan);
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

// f(k, number, length) of each row of points of a tile that stand together in the grid too: the first of them within the tile, and within
// the grid, whose points are all those of `grid`.
template <class F>
void each_row(const Tile& tile, const Tile& grid, F&& f) {
  Tile firsts = tile;
  std::size_t length = 1;
  if (!tile.end.empty()) {
    length = tile.end.back() - tile.begin.back();
    firsts.end.back() = firsts.begin.back() + 1;
  }
  each_point(firsts, [&](std::size_t row, std::span<const std::size_t> at) { f(row * length, grid.place(at), length); });
}

}  // namespace pmreport::scan
