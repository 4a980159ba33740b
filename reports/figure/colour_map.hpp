// Values over a grid as colours: a filled map and its contour.
#pragma once

#include <cairo.h>

#include <vector>

#include <reports/figure/curve.hpp>
#include <reports/figure/figure.hpp>

namespace pmreport::figure {

// Where bilinear values are at the level of the map, as straight pieces joined to strokes. A cell with a value missing has none; nor has
// one of a diverging map where the sign changes between values that both lie beyond the colours, at a pole.
std::vector<Stroke> level_contour(const ColourMap& map, const Frame& frame);

// Fills that part of the frame that the grid covers; the frame's top left corner is the origin. What is out of reach is grey and hatched.
void draw_map(cairo_t* cr, const ColourMap& map, const Frame& frame);
// The fill of a class, or of what is out of reach, in a box of the legend.
void draw_fill(cairo_t* cr, int number, const Box& box);
void draw_contour(cairo_t* cr, const std::vector<Stroke>& contour);

constexpr double contour_width = 1.3;  // [pt]

}  // namespace pmreport::figure
