// Points that fill a box evenly, however many there are.
#pragma once

#include <cstddef>
#include <vector>

namespace pmreport::analysis {

// Most coordinates that a spread can have.
inline constexpr std::size_t most_variables = 8;

// The first points of Halton's sequence (1960), coordinates from 0 to 1: coordinate i of point k is k + 1 written in the i-th prime,
// mirrored at the point. n at most `most_variables`.
std::vector<std::vector<double>> spread(std::size_t count, std::size_t n);

}  // namespace pmreport::analysis
