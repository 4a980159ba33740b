// Ranges of numbers, and what a function makes of them: it takes no value outside the range that is returned for it. Rounding is not
// counted outwards: a range tells how finely to look, it proves nothing.
#pragma once

#include <core/scenario/expression/expression.hpp>
#include <vector>

namespace pmreport::scenario {

struct Range {
  double low = 0, high = 0;  // infinite where nothing bounds it
  double width() const { return high - low; }
  bool has(double x) const { return low <= x && x <= high; }
};

// The range of every term of an expression of t alone, t in [begin, end], in the terms' order.
void ranges_of(std::span<const Term> terms, double begin, double end, std::vector<Range>& out);

}  // namespace pmreport::scenario
