#include <png.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <random>
#include <reports/scene/scene.hpp>

using pmreport::scene::Image;
using pmreport::scene::to_png;

namespace {

Image noise(int width, int height, bool opaque) {
  std::mt19937 random(3);
  Image image{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * width * height))};
  for (std::size_t i = 0; i < image.rgba.size(); ++i) image.rgba[i] = i % 4 == 3 && opaque ? 255 : static_cast<std::uint8_t>(random());
  return image;
}

std::vector<std::uint8_t> decode(const std::string& bytes, png_uint_32& width, png_uint_32& height) {
  png_image in{};
  in.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&in, bytes.data(), bytes.size()) != 0);
  in.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(in));
  width = in.width, height = in.height;
  REQUIRE(png_image_finish_read(&in, nullptr, pixels.data(), 0, nullptr) != 0);
  return pixels;
}

}  // namespace

TEST_CASE("a picture comes back from its PNG pixel by pixel") {
  for (const bool opaque : {true, false}) {
    const Image image = noise(37, 23, opaque);
    const std::string png = to_png(image);
    png_uint_32 width = 0, height = 0;
    CHECK((decode(png, width, height) == image.rgba));
    CHECK(width == 37);
    CHECK(height == 23);
    CHECK(to_png(image) == png);
    CHECK(png.find("sRGB") != std::string::npos);
    CHECK(png.find("tIME") == std::string::npos);
  }
}

TEST_CASE("an opaque picture is written without alpha") {
  constexpr std::size_t color_type = 25;  // 8 of signature, 8 of chunk head, 9 into IHDR
  CHECK(to_png(noise(5, 5, true))[color_type] == PNG_COLOR_TYPE_RGB);
  CHECK(to_png(noise(5, 5, false))[color_type] == PNG_COLOR_TYPE_RGB_ALPHA);
}

TEST_CASE("a picture without pixels, or with too few, is refused") {
  CHECK_THROWS_AS(to_png({}), std::runtime_error);
  CHECK_THROWS_AS(to_png({10, 10, std::vector<std::uint8_t>(12)}), std::runtime_error);
}
