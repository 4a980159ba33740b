#include <png.h>

#include <reports/scene/scene.hpp>
#include <stdexcept>
#include <string>

namespace pmreport::scene {

namespace {

void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}
void nothing_to_flush(png_structp) {}
[[noreturn]] void refuse(png_structp, png_const_charp why) { throw std::runtime_error(std::string("PNG: ") + why); }
void ignore(png_structp, png_const_charp) {}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, refuse, ignore);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

}  // namespace

// The up filter alone: smooth shading compresses well with it, and the usual trial of all five takes three times as long for a few percent.
// Fixed level and strategy, and no time chunk: the same picture gives the same bytes. A picture without transparency is written without
// alpha.
std::string to_png(const Image& image) {
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  if (image.width < 1 || image.height < 1 || image.rgba.size() != 4 * width * height)
    throw std::runtime_error("PNG: the picture has no pixels, or not as many as it says");
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;

  std::string out;
  Writer w;
  if (w.info == nullptr) throw std::runtime_error("PNG: no memory");
  png_set_write_fn(w.png, &out, append, nothing_to_flush);
  png_set_compression_level(w.png, 4);
  png_set_filter(w.png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  png_set_IHDR(w.png, w.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(w.png, w.info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(w.png, w.info);
  if (opaque) png_set_filler(w.png, 0, PNG_FILLER_AFTER);  // drops the fourth byte
  for (std::size_t y = 0; y < height; ++y) png_write_row(w.png, image.rgba.data() + 4 * width * y);
  png_write_end(w.png, nullptr);
  return out;
}

}  // namespace pmreport::scene
