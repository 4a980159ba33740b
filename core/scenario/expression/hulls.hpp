// Hulls of any run of neighbours in a long row of bounds, each in a logarithm of its length.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <vector>

namespace pmreport::scenario {

// A tree on the row: node i has the hull of nodes 2 i and 2 i + 1, and the row itself stands at the end.
class Hulls {
 public:
  Hulls() = default;
  explicit Hulls(const std::vector<program::Bounds>& row) : size_(row.size()), nodes_(2 * row.size()) {
    std::copy(row.begin(), row.end(), nodes_.begin() + static_cast<std::ptrdiff_t>(size_));
    for (std::size_t i = size_; i-- > 1;) nodes_[i] = hull(nodes_[2 * i], nodes_[2 * i + 1]);
  }

  // Of first, first + 1, ... last.
  program::Bounds of(std::size_t first, std::size_t last) const {
    program::Bounds out = nodes_[first + size_];
    for (std::size_t l = first + size_, r = last + size_ + 1; l < r; l /= 2, r /= 2) {
      if (l % 2 == 1) out = hull(out, nodes_[l++]);
      if (r % 2 == 1) out = hull(out, nodes_[--r]);
    }
    return out;
  }

 private:
  std::size_t size_ = 0;
  std::vector<program::Bounds> nodes_;
};

}  // namespace pmreport::scenario
