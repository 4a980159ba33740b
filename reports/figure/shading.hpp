// Shaded intervals of x.
#pragma once

#include <cairo.h>

#include <vector>

#include <reports/figure/curve.hpp>
#include <reports/figure/figure.hpp>
#include <reports/figure/geometry.hpp>

namespace pmreport::figure {

// The bands of one kind inside the frame, merged where they touch, none thinner than a line that prints. Panel coordinates [pt].
std::vector<Box> band_boxes(const std::vector<Band>& bands, Band::Kind kind, const Frame& frame);

// A broken limit is amber and hatched, out of reach is plain grey: they differ in grey print too.
void shade(cairo_t* cr, const std::vector<Box>& boxes, Band::Kind kind);

}  // namespace pmreport::figure
