// The share of a box that a half-space covers, rounded outward.
#pragma once

#include <core/program/intervals/bounds.hpp>

#include <cstddef>
#include <span>

namespace pmreport::scan {

constexpr std::size_t most_axes = 16;  // of a box whose share is asked

// Bounds of the share of [-1, 1]^d in which c + w.x >= 0, for all c within the bounds: its least at the low end, its greatest at the high
// one. Signs of the weights do not matter. d is at most `most_axes`; weights and ends are finite.
program::Bounds half_space_share(program::Bounds c, std::span<const double> weights);

// The same; rounding must go upward.
program::Bounds half_space_share_upward(program::Bounds c, std::span<const double> weights);

}  // namespace pmreport::scan
