// Points that count, and the numbers beside them.
#pragma once

#include <cairo.h>

#include <vector>

#include <reports/figure/curve.hpp>
#include <reports/figure/figure.hpp>
#include <reports/figure/layout/occupancy.hpp>

namespace pmreport::figure {

// A place for each number near its point, inside the frame and off the ink where that can be. Panel coordinates [pt]; of a mark outside the
// frame a box without size.
std::vector<Box> place_marks(cairo_t* cr, const std::vector<Mark>& marks, const Occupancy& ink, const Frame& frame);

void draw_marks(cairo_t* cr, const std::vector<Mark>& marks, const std::vector<Box>& places, const Frame& frame);

}  // namespace pmreport::figure
