// What colour a value has: the scales of a map, and the fills of its classes.
#pragma once

#include <reports/figure/figure.hpp>
#include <reports/figure/layout/axis.hpp>
#include <reports/figure/palette.hpp>

namespace pmreport::figure {

// Blue below zero, white at it, red above, equally far from white at equal distance: -1 to 1; beyond, the end colours. After C. Brewer's
// RdBu: its two arms differ for every kind of colour vision, and each grows darker steadily.
Colour diverging(double value);

// Dark blue at 0, yellow at 1, lighter at an even pace, for every kind of colour vision and in grey: viridis, S. van der Walt and N. Smith
// (2015).
Colour sequential(double value);

// The values at which the colours end. Diverging: the magnitude that 98 of 100 values do not exceed, on both sides, so that a pole does not
// bleach the rest. Sequential: least and most; where the values beyond those that one in a hundred exceeds would take more than a fifth of
// the scale, these instead. Of a map without a value -1 to 1.
Interval colour_range(const ColourMap& map);
// "beyond the colours: up to 4×10³"; empty where nothing is.
std::string beyond_the_colours(const ColourMap& map);

// In steps that a reader can tell apart. `range`: of colour_range().
Colour colour_of(const ColourMap& map, const Interval& range, double value);

// The fill of a class at a pixel, `pixels_per_point` a point: light, each with a pattern of its own besides its tint, so that they differ
// in grey print; that of class 0 is plain. Numbers beyond `classes` begin again. -1: out of reach, grey and hatched.
Colour fill_of(int number, int row, int column);

constexpr int classes = 12;
constexpr int colour_levels = 24;    // steps from one end of a scale to the other: a reader can tell them apart
constexpr int pixels_per_point = 3;  // 216 an inch: steps of colour look straight in print

}  // namespace pmreport::figure
