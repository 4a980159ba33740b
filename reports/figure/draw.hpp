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
// Text as glyph outlines, so that it looks alike everywhere, with invisible text over them for those who search and select. Ids are
// prefixed by f.id: several fit one HTML. A page finds panels (class "panel", data-frame: x, y, width, height; data-x, data-y: ranges in
// data units), curves ("curve", data-series: which of its panel's) and keys of the legend ("key", data-series) as groups.
std::string to_svg(const Figure& f);

}  // namespace pmreport::figure
