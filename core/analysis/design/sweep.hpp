// Variants over one or two variables.
#pragma once

#include <core/analysis/design/problem.hpp>

#include <vector>

namespace pmreport::analysis {

struct SweptVariable {
  double from = 0, to = 0;  // SI
  std::size_t count = 2;    // 2 or more

  double value(std::size_t k) const {
    return k + 1 == count ? to : from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1);
  }
};

// All variants of one or two variables, the last fastest. Same numbers for any number of threads.
struct Sweep {
  std::vector<std::vector<double>> values;  // one list a variant
  std::vector<Judged> judged;
};
Sweep sweep(const std::vector<SweptVariable>& variables, const Judge& judge, const Progress& progress);

}  // namespace pmreport::analysis
