// Indices of transmission over a grid of poses: means, extremes, and how much of it transmits well.
#pragma once

#include <core/analysis/transmission/request.hpp>
#include <core/analysis/transmission/transmission_numbers.hpp>

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace pmreport::analysis {

struct IndexOverGrid {
  double mean = std::numeric_limits<double>::quiet_NaN();  // over the poses that have the number, each weighing alike; NaN: none has
  double least = std::numeric_limits<double>::quiet_NaN(), most = least;
  Eigen::VectorXd least_at, most_at;  // coordinates of the first pose of that number
  std::size_t counted = 0;            // poses that have it
  std::size_t good = 0;               // at good_transmission or above
};

struct TransmissionGrid {
  std::size_t poses = 0;               // of the grid
  std::size_t accepted = 0;            // that keep the limits
  std::vector<IndexOverGrid> indices;  // of the accepted poses, in the order of transmission_columns
  std::vector<std::string> left_out;   // joints whose motion the geometry leaves open: not judged
};
// Value k of a range is from + (to - from) k / (count - 1). A pose counts where it can be assembled and keeps the limits, ends included;
// coordinates without a range are at home. Nothing where the limits cannot be judged, with a sentence.
std::optional<TransmissionGrid> transmission_grid(const mechanics::Transmission& t, const GridRequest& request, std::string* why = nullptr);

}  // namespace pmreport::analysis
