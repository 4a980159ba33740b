#include <reports/document/narrowed.hpp>

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

namespace pmreport::document {

namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

struct Reader {
  const std::string& png;
  std::size_t at = 0;
};
cairo_status_t read(void* closure, unsigned char* data, unsigned int length) {
  Reader& r = *static_cast<Reader*>(closure);
  if (r.png.size() - r.at < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, r.png.data() + r.at, length);
  r.at += length;
  return CAIRO_STATUS_SUCCESS;
}
cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string narrowed(const std::string& png, int width) {
  Reader reader{png};
  const Surface large(cairo_image_surface_create_from_png_stream(read, &reader), cairo_surface_destroy);
  if (cairo_surface_status(large.get()) != CAIRO_STATUS_SUCCESS) return png;
  const int from_width = cairo_image_surface_get_width(large.get()), from_height = cairo_image_surface_get_height(large.get());
  if (from_width <= width) return png;
  const double scale = static_cast<double>(width) / from_width;
  const int height = std::max(1, static_cast<int>(std::lround(scale * from_height)));
  const Surface small(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  cairo_t* drawing = cairo_create(small.get());
  cairo_set_source_rgb(drawing, 1, 1, 1);
  cairo_paint(drawing);
  cairo_scale(drawing, scale, static_cast<double>(height) / from_height);
  cairo_set_source_surface(drawing, large.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(drawing), CAIRO_FILTER_GOOD);
  cairo_pattern_set_extend(cairo_get_source(drawing), CAIRO_EXTEND_PAD);
  cairo_paint(drawing);
  cairo_destroy(drawing);
  std::string out;
  return cairo_surface_write_to_png_stream(small.get(), append, &out) == CAIRO_STATUS_SUCCESS ? out : png;
}

}  // namespace pmreport::document
