// A figure on paper: sizes, vectors, files.
#pragma once

#include <cairo.h>
#include <reports/figure/figure.hpp>

#include <string>

namespace pmreport::figure {

struct Size {
  double width, height;  // [pt]
};
Size size_of(const Figure& f);

// Draws into `cr` at the origin, size_of(f) large, as vectors and text.
void draw(cairo_t* cr, const Figure& f);

std::string to_pdf(const Figure& f);  // one page, fonts embedded; same bytes every time
// Text as glyph outlines, so that it looks alike everywhere; ids prefixed by f.id: several fit one HTML.
std::string to_svg(const Figure& f);

}  // namespace pmreport::figure
