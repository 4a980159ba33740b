// Points of a grid and those one step on one axis away.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pmreport::scan {

class Neighbours {
 public:
  explicit Neighbours(const std::vector<std::size_t>& counts) : counts_(counts), strides_(counts.size(), 1) {  // the last axis fastest
    for (std::size_t a = counts.size(); a-- > 1;) strides_[a - 1] = strides_[a] * counts[a];
  }

  // Marks in `seen`, and counts, the start and all that is connected with it over points that `belongs` accepts; those already seen are
  // left out. `rim` is told of each whether it has a neighbour less than others: an axis with a single value makes no rim.
  template <class Belongs, class Rim>
  std::uint64_t flood(std::size_t start, std::vector<bool>& seen, Belongs&& belongs, Rim&& rim) const {
    std::vector<std::size_t> open{start};
    seen[start] = true;
    std::uint64_t count = 0;
    while (!open.empty()) {
      const std::size_t n = open.back();
      open.pop_back();
      ++count;
      const auto visit = [&](std::size_t neighbour) {
        if (seen[neighbour] || !belongs(neighbour)) return;
        seen[neighbour] = true;
        open.push_back(neighbour);
      };
      bool at_the_rim = false;
      for (std::size_t a = 0; a < counts_.size(); ++a) {
        if (counts_[a] < 2) continue;
        const std::size_t place = n / strides_[a] % counts_[a];
        if (place > 0) visit(n - strides_[a]);
        if (place + 1 < counts_[a]) visit(n + strides_[a]);
        at_the_rim = at_the_rim || place == 0 || place + 1 == counts_[a];
      }
      rim(at_the_rim);
    }
    return count;
  }

 private:
  std::vector<std::size_t> counts_, strides_;
};

}  // namespace pmreport::scan
