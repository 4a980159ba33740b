// Which parts of a frame carry ink: a raster with a summed-area table, so that any box is asked in constant time.
#pragma once

#include <cstddef>
#include <vector>

#include <reports/figure/geometry.hpp>

namespace pmreport::figure {

class Occupancy {
 public:
  Occupancy(double width, double height);  // [pt]
  void mark(Point from, Point to);         // a straight piece of ink
  void mark(const Box& box);
  void seal();                         // after the last mark and before the first question
  double share(const Box& box) const;  // of the box that is occupied, 0 to 1
  bool free(const Box& box) const { return share(box) == 0; }

 private:
  static constexpr double cell_ = 1.5;  // [pt]
  std::size_t columns_, rows_;
  std::vector<int> sums_;  // rows_ + 1 by columns_ + 1: marks before sealing, sums of all cells above and left after
  int& at(std::size_t row, std::size_t column) { return sums_[row * (columns_ + 1) + column]; }
  int at(std::size_t row, std::size_t column) const { return sums_[row * (columns_ + 1) + column]; }
  void mark_cell(double x, double y);
  static std::size_t index(double coordinate, std::size_t count);  // of the cell, the nearest one outside
};

}  // namespace pmreport::figure
