#include <reports/document/pdf/pdf_link.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::document::pdf {

Box on_paper(cairo_t* cr, const Box& box) {
  double x = box.x, y = box.y;
  cairo_user_to_device(cr, &x, &y);
  return {x, y, box.width, box.height};
}

namespace {

// Cairo takes the numbers in attributes in the page's own space, whatever the transformation.
std::string rectangle(cairo_t* cr, const Box& box) {
  const Box b = on_paper(cr, box);
  return fmt::format("rect=[{:.2f} {:.2f} {:.2f} {:.2f}]", b.x, b.y, b.width, b.height);
}

}  // namespace

std::string link_to(cairo_t* cr, const std::string& destination, const Box& box) {
  return fmt::format("dest='{}' {}", destination, rectangle(cr, box));
}

// Relative to the report: viewers resolve it against the place of the file they show.
std::string file_link_to(cairo_t* cr, const std::string& file, const Box& box) {
  return fmt::format("uri='{}' {}", file, rectangle(cr, box));
}

void set_destination(cairo_t* cr, const std::string& name) {
  double x = 0, y = 0;
  cairo_user_to_device(cr, &x, &y);
  constexpr double air = 8;  // [pt]
  const Tag tag(cr, CAIRO_TAG_DEST, fmt::format("name='{}' x={:.2f} y={:.2f}", name, x, std::max(0.0, y - air)));
}

}  // namespace pmreport::document::pdf
