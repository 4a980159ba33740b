// Margins in stages: which are looked at together, and in which order.
#pragma once

#include <core/program/program.hpp>

#include <span>
#include <vector>

namespace pmreport::scan {

// Outputs 0 ... margins - 1 of a program in groups. `seen`: margins of poses, one margin after the other; what refuses many of those that
// are left for few operations comes first, and with it what costs next to nothing beside it.
std::vector<std::vector<int>> stages_by_yield(const program::Program& program, std::size_t margins, std::span<const double> rounding,
                                              std::span<const double> seen);

// In their order, the first alone; margins that share little of what they are computed from part.
std::vector<std::vector<int>> stages_in_order(const program::Program& program, std::size_t margins);

}  // namespace pmreport::scan
