#include <reports/document/few_colors.hpp>
#include <reports/document/narrowed.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace pmreport::document {

namespace {

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

// Null when the bytes are no PNG.
Surface read_png(const std::string& png) {
  Reader reader{png};
  Surface source(cairo_image_surface_create_from_png_stream(read, &reader));
  return cairo_surface_status(source.get()) == CAIRO_STATUS_SUCCESS ? std::move(source) : nullptr;
}

Surface on_white(cairo_surface_t* source, int width) {
  const int w = cairo_image_surface_get_width(source), h = cairo_image_surface_get_height(source);
  const double scale = std::min(1.0, static_cast<double>(width) / w);
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(std::lround(scale * length))); };
  Surface result(cairo_image_surface_create(CAIRO_FORMAT_RGB24, scaled(w), scaled(h)));
  cairo_t* cr = cairo_create(result.get());
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_paint(cr);
  cairo_scale(cr, static_cast<double>(scaled(w)) / w, static_cast<double>(scaled(h)) / h);
  cairo_set_source_surface(cr, source, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), scale < 1 ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
  cairo_pattern_set_extend(cairo_get_source(cr), CAIRO_EXTEND_PAD);
  cairo_paint(cr);
  cairo_destroy(cr);
  return result;
}

}  // namespace

Surface decoded(const std::string& png, int width) {
  const Surface source = read_png(png);
  return source ? on_white(source.get(), width) : nullptr;
}

std::string narrowed(const std::string& png, int width) {
  const Surface picture = decoded(png, width);
  std::string out = png_of_few_colors(picture.get());
  return out.empty() ? png : out;
}

}  // namespace pmreport::document
