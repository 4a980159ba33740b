#include <reports/figure/layout/occupancy.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::figure {

Occupancy::Occupancy(double width, double height)
    : columns_(static_cast<std::size_t>(std::ceil(width / cell_)) + 1),
      rows_(static_cast<std::size_t>(std::ceil(height / cell_)) + 1),
      sums_((rows_ + 1) * (columns_ + 1), 0) {}

std::size_t Occupancy::index(double coordinate, std::size_t count) {
  return static_cast<std::size_t>(std::clamp(coordinate / cell_, 0.0, static_cast<double>(count - 1)));
}

void Occupancy::mark_cell(double x, double y) { at(index(y, rows_) + 1, index(x, columns_) + 1) = 1; }

void Occupancy::mark(Point from, Point to) {
  // Steps of a third of a cell miss at most a cell's corner, less than the clearance that a legend keeps.
  const int steps = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / (cell_ / 3)) + 1;
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    mark_cell(from.x + s * (to.x - from.x), from.y + s * (to.y - from.y));
  }
}

void Occupancy::mark(const Box& box) {
  for (std::size_t row = index(box.y, rows_); row <= index(box.bottom(), rows_); ++row) {
    for (std::size_t column = index(box.x, columns_); column <= index(box.right(), columns_); ++column) at(row + 1, column + 1) = 1;
  }
}

void Occupancy::seal() {
  for (std::size_t row = 1; row <= rows_; ++row) {
    for (std::size_t column = 1; column <= columns_; ++column) {
      at(row, column) += at(row - 1, column) + at(row, column - 1) - at(row - 1, column - 1);
    }
  }
}

double Occupancy::share(const Box& box) const {
  const std::size_t top = index(box.y, rows_), bottom = index(box.bottom(), rows_) + 1;
  const std::size_t left = index(box.x, columns_), right = index(box.right(), columns_) + 1;
  const int marked = at(bottom, right) - at(top, right) - at(bottom, left) + at(top, left);
  return static_cast<double>(marked) / static_cast<double>((bottom - top) * (right - left));
}

}  // namespace pmreport::figure
