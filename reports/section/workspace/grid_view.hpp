// A grid of two axes as a panel shows it: in units that read best, both axes running upward.
#pragma once

#include <core/scan/pose_set.hpp>
#include <pmreport/topology.hpp>
#include <reports/figure/figure.hpp>

#include <array>
#include <vector>

namespace pmreport::section {

// Values over the grid are as a scan has them: the second axis fastest, both in the scan's own direction.
class GridView {
 public:
  // Another number of axes, or an axis with a single value: std::invalid_argument.
  GridView(const std::vector<scan::Axis>& axes, const std::array<Coordinate, 2>& coordinates);

  std::vector<double> x, y;  // of the first and the second axis, increasing [display units]

  figure::Panel panel() const;                                        // with its axes alone
  GridView refined(std::size_t points) const;                         // so many on each axis, about, those of this grid among them
  std::vector<double> rows(const std::vector<double>& values) const;  // as a map has them: row by row upward, x along a row

  double column(double at) const;  // places as fractions of steps from the first value
  double row(double at) const;
  // Bilinear among the corners that are numbers, at places counted in columns and rows; none where none of them is.
  double between(const std::vector<double>& values, double column, double row) const;

 private:
  std::array<figure::Axis, 2> names_;
  std::array<bool, 2> downward_{};  // the axis of the scan runs so
  double at(const std::vector<double>& values, std::size_t column, std::size_t row) const;
};

}  // namespace pmreport::section
