// Pictures made smaller for the page.
#include <catch2/catch.hpp>

#include <reports/document/narrowed.hpp>
#include <tests/document/sample.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

using namespace pmreport::document;

namespace {

int number_at(const std::string& png, std::size_t at) {
  int value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = 256 * value + static_cast<unsigned char>(png[at + i]);
  return value;
}
int width_of(const std::string& png) { return number_at(png, 16); }
int height_of(const std::string& png) { return number_at(png, 20); }

// An opaque picture, of colours 0xRRGGBB.
template <class Color>
Surface painted(int width, int height, Color color) {
  Surface out(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto value = static_cast<std::uint32_t>(color(x, y));
      std::memcpy(cairo_image_surface_get_data(out.get()) + y * cairo_image_surface_get_stride(out.get()) + 4 * x, &value, 4);
    }
  cairo_surface_mark_dirty(out.get());
  return out;
}
int pixel(cairo_surface_t* of, int x, int y) {
  std::uint32_t value = 0;
  std::memcpy(&value, cairo_image_surface_get_data(of) + y * cairo_image_surface_get_stride(of) + 4 * x, 4);
  return static_cast<int>(value & 0xffffff);
}
std::string png_of(cairo_surface_t* picture) {
  std::string out;
  cairo_surface_write_to_png_stream(
      picture,
      [](void* to, const unsigned char* bytes, unsigned count) {
        static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(bytes), count);
        return CAIRO_STATUS_SUCCESS;
      },
      &out);
  return out;
}

std::string sample_png() {
  const Report r = sample::report();
  for (const Section& s : r.sections)
    for (const Block& b : s.blocks)
      if (const auto* g = std::get_if<Gallery>(&b)) return g->pictures.front().png;
  return "";
}

}  // namespace

TEST_CASE("a picture is made as wide as asked in its proportions, and never wider") {
  const std::string png = sample_png();
  REQUIRE(png.starts_with("\x89PNG"));
  const int width = width_of(png), height = height_of(png);
  REQUIRE(width > 2);
  CHECK(width_of(narrowed(png, width)) == width);
  CHECK(narrowed(png, 10 * width) == narrowed(png, width));
  const std::string half = narrowed(png, width / 2);
  CHECK(width_of(half) == width / 2);
  CHECK(std::abs(height_of(half) - height / 2) <= 1);
  CHECK(narrowed(png, width / 2) == half);
}

TEST_CASE("a picture of few colours keeps every one of them") {
  const Surface drawn = painted(64, 48, [](int x, int y) { return 0x10000 * (3 * (x / 8)) + 0x100 * (5 * (y / 4)) + 255; });
  const std::string png = png_of(drawn.get());
  const Surface back = decoded(narrowed(png, 64), 64);
  REQUIRE(back);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) CHECK(pixel(back.get(), x, y) == pixel(drawn.get(), x, y));
}

TEST_CASE("a shaded picture is half as large, its ground white and no pixel far from what it was") {
  // Two shaded balls on white, with a shadow that fades out: some ten thousand colours.
  const auto shade = [](double x, double y, double cx, int r, int g, int b) {
    const double d2 = ((x - cx) * (x - cx) + (y - 200) * (y - 200)) / (120.0 * 120.0);
    if (d2 > 1) return -1;
    const double light = 0.3 + 0.7 * std::max(0.0, 0.6 * std::sqrt(1 - d2) - 0.5 * (x - cx) / 120 - 0.5 * (y - 200) / 120);
    const auto channel = [&](int c) { return std::clamp(static_cast<int>(std::lround(c * light)), 0, 255); };
    return 0x10000 * channel(r) + 0x100 * channel(g) + channel(b);
  };
  const Surface drawn = painted(640, 400, [&](int x, int y) {
    for (const int ball : {shade(x, y, 200, 60, 130, 250), shade(x, y, 420, 250, 140, 40)})
      if (ball >= 0) return ball;
    const int grey = std::min(255, 225 + static_cast<int>(std::hypot(x - 320, 2 * (y - 330)) / 8));
    return 0x10101 * grey;
  });
  const std::string png = png_of(drawn.get()), light = narrowed(png, 640);
  CHECK(2 * light.size() < png.size());
  CHECK(narrowed(png, 640) == light);
  const Surface back = decoded(light, 640);
  REQUIRE(back);
  double sum = 0;
  int worst = 0;
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 640; ++x) {
      const int was = pixel(drawn.get(), x, y), is = pixel(back.get(), x, y);
      if (was == 0xffffff && is != was) FAIL("white became " << is << " at " << x << ", " << y);
      int most = 0;
      for (const int shift : {0, 8, 16}) most = std::max(most, std::abs(((was >> shift) & 255) - ((is >> shift) & 255)));
      worst = std::max(worst, most);
      sum += most;
    }
  // A cube of 2⁸ colours for 2¹⁴ leaves each some four of 255 levels either way.
  CHECK(sum / (640 * 400) < 2);
  CHECK(worst < 20);
}

TEST_CASE("what is no picture stays as it is") {
  CHECK(narrowed("", 10).empty());
  CHECK(narrowed("<svg/>", 10) == "<svg/>");
  const std::string png = sample_png();
  CHECK(narrowed(png.substr(0, png.size() / 2), 1).size() > 0);
}
