// The bar beside a map that explains its colours. Classes have none: the legend explains them.
#pragma once

#include <cairo.h>

#include <reports/figure/figure.hpp>
#include <reports/figure/layout/axis.hpp>

namespace pmreport::figure {

// Its colours, ticks and title, from x = `left`; and how wide all of it is.
struct ColourBar {
  Scale scale;
  double widest = 0;  // [pt] of the numbers
};
ColourBar lay_out_bar(cairo_t* cr, const ColourMap& map, double height);
double bar_width(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double height);
void draw_bar(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double left, double height);

constexpr double bar_gap = 6;  // [pt] from the frame to the bar

}  // namespace pmreport::figure
