#include <reports/document/pdf/pdf_link.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::document::pdf {

namespace {

// Cairo takes the numbers in attributes in the page's own space, whatever the transformation.
std::string rectangle(cairo_t* cr, const Box& box) {
  double x = box.x, y = box.y;
  cairo_user_to_device(cr, &x, &y);
  return fmt::format("rect=[{:.2f} {:.2f} {:.2f} {:.2f}]", x, y, box.width, box.height);
}

}  // namespace

Link::Link(cairo_t* cr, const std::string& destination, const Box& box)
    : Tag(cr, CAIRO_TAG_LINK, fmt::format("dest='{}' {}", destination, rectangle(cr, box))) {}

void set_destination(cairo_t* cr, const std::string& name) {
  double x = 0, y = 0;
  cairo_user_to_device(cr, &x, &y);
  constexpr double air = 8;  // [pt]
  const Tag tag(cr, CAIRO_TAG_DEST, fmt::format("name='{}' x={:.2f} y={:.2f}", name, x, std::max(0.0, y - air)));
}

}  // namespace pmreport::document::pdf
