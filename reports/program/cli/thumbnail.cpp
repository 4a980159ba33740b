#include <reports/program/cli/thumbnail.hpp>

#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace pmreport::program {

namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

cairo_status_t append(void* text, const unsigned char* bytes, unsigned count) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

std::string thumbnail(const std::filesystem::path& png, int width) {
  const Surface large(cairo_image_surface_create_from_png(png.c_str()), cairo_surface_destroy);
  if (cairo_surface_status(large.get()) != CAIRO_STATUS_SUCCESS) return "";
  const int from_width = cairo_image_surface_get_width(large.get()), from_height = cairo_image_surface_get_height(large.get());
  const double scale = std::min(1.0, static_cast<double>(width) / from_width);
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(std::lround(scale * length))); };
  const Surface small(cairo_image_surface_create(CAIRO_FORMAT_RGB24, scaled(from_width), scaled(from_height)), cairo_surface_destroy);
  cairo_t* drawing = cairo_create(small.get());
  cairo_set_source_rgb(drawing, 1, 1, 1);  // the paper of a transparent ground
  cairo_paint(drawing);
  cairo_scale(drawing, scale, scale);
  cairo_set_source_surface(drawing, large.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(drawing), CAIRO_FILTER_BEST);
  cairo_paint(drawing);
  cairo_destroy(drawing);
  std::string out;
  return cairo_surface_write_to_png_stream(small.get(), append, &out) == CAIRO_STATUS_SUCCESS ? out : "";
}

}  // namespace pmreport::program
