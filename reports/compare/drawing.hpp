// Curves over each other, and their difference.
#pragma once

#include <reports/compare/comparison.hpp>
#include <reports/figure/figure.hpp>

#include <vector>

namespace pmreport::compare {

constexpr std::size_t most_drawn = 24;

// One figure a curve that differs: all reports on shared axes, and below them each one's difference from the first. Of more than
// `most_drawn` those that differ most, for their size; in the order of the comparison.
std::vector<figure::Figure> figures_of(const Comparison& c);

// How many curves differ and are shared: those that figures_of chooses from.
std::size_t curves_to_draw(const Comparison& c);

}  // namespace pmreport::compare
