// Poses over two coordinates, and what is computed at each of them.
#pragma once

#include <tbb/parallel_for.h>
#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace pmreport::analysis {

struct PoseMap {
  int coordinate[2] = {0, 1};  // indices
  double from[2] = {0, 0}, to[2] = {0, 0};
  Eigen::VectorXd at;  // the other coordinates; home unless given
  int points = 61;     // along each

  // Value k of the points along axis 0 or 1 [m], [rad].
  double value(int axis, std::size_t k) const {
    return from[axis] + (to[axis] - from[axis]) * static_cast<double>(k) / static_cast<double>(points - 1);
  }
};

// `count` numbers of every pose of the map: a list each, row by row, `points` poses a row, the first coordinate rising along it.
// `make_worker` is called once a row, by any thread, and makes what is then called as worker(coordinates, numbers), with dof coordinates
// [m], [rad], to fill `count` numbers that are NaN before. `map.at` must be as long as the coordinates.
template <class MakeWorker>
std::vector<std::vector<double>> over_map(const PoseMap& map, std::size_t count, MakeWorker&& make_worker) {
  const auto n = static_cast<std::size_t>(map.points);
  std::vector<std::vector<double>> out(count, std::vector<double>(n * n, std::numeric_limits<double>::quiet_NaN()));
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t row) {
    auto worker = make_worker();
    Eigen::VectorXd q = map.at;
    std::vector<double> numbers(count);
    q(map.coordinate[1]) = map.value(1, row);
    for (std::size_t k = 0; k < n; ++k) {
      q(map.coordinate[0]) = map.value(0, k);
      numbers.assign(count, std::numeric_limits<double>::quiet_NaN());
      worker(std::span<const double>(q.data(), static_cast<std::size_t>(q.size())), std::span<double>(numbers));
      for (std::size_t i = 0; i < count; ++i) out[i][row * n + k] = numbers[i];
    }
  });
  return out;
}

}  // namespace pmreport::analysis
