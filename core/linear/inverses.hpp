// Inverses of many matrices at once.
#pragma once

#include <cstddef>

namespace pmreport::linear {

// Of matrices of six rows, by elimination with row pivots, in the vectors of the processor; the digits are the same on all. Entry (r, c) of
// matrix k stands at [(6 r + c) * count + k] in both. A singular matrix is not refused: what comes out is infinite, or NaN, or large.
void inverses(std::size_t count, const double* matrices, double* out);

}  // namespace pmreport::linear
