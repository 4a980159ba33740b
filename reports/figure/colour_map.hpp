// Values over a grid as colours: a filled map on a diverging scale, its contour of zero, the bar that explains the colours.
#pragma once

#include <cairo.h>

#include <vector>

#include <reports/figure/curve.hpp>
#include <reports/figure/figure.hpp>
#include <reports/figure/layout/axis.hpp>
#include <reports/figure/palette.hpp>

namespace pmreport::figure {

// Blue below zero, white at it, red above, equally far from white at equal distance: -1 to 1; beyond, the end colours. After C. Brewer's
// RdBu: its two arms differ for every kind of colour vision, and each grows darker steadily.
Colour diverging(double value);

// The magnitude at which the colours end: that which 98 of 100 values do not exceed, so that a pole does not bleach the rest. 1 for a map
// without a value.
double colour_limit(const ColourMap& map);

// Where bilinear values are zero, as straight pieces joined to strokes. A cell with a value missing has none; nor has one where the sign
// changes between values that both lie beyond the colours, at a pole.
std::vector<Stroke> zero_contour(const ColourMap& map, const Frame& frame);

// Fills the frame, whose top left corner is the origin. What is out of reach is grey and hatched.
void draw_map(cairo_t* cr, const ColourMap& map, double width, double height);
void draw_contour(cairo_t* cr, const std::vector<Stroke>& contour);

// The bar beside the frame: its colours, ticks and title, from x = `left`; and how wide all of it is.
struct ColourBar {
  Scale scale;
  double widest = 0;  // [pt] of the numbers
};
ColourBar lay_out_bar(cairo_t* cr, const ColourMap& map, double height);
double bar_width(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double height);
void draw_bar(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double left, double height);

constexpr double bar_gap = 6;          // [pt] from the frame to the bar
constexpr double contour_width = 1.3;  // [pt]
constexpr int colour_levels = 24;      // steps from one end of the scale to the other: a reader can tell them apart

}  // namespace pmreport::figure
