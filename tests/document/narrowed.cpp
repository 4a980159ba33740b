// Pictures made smaller for the page.
#include <catch2/catch.hpp>

#include <reports/document/narrowed.hpp>
#include <tests/document/sample.hpp>

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
  CHECK(narrowed(png, width) == png);
  CHECK(narrowed(png, 10 * width) == png);
  const std::string half = narrowed(png, width / 2);
  CHECK(width_of(half) == width / 2);
  CHECK(std::abs(height_of(half) - height / 2) <= 1);
  CHECK(narrowed(png, width / 2) == half);
}

TEST_CASE("what is no picture stays as it is") {
  CHECK(narrowed("", 10).empty());
  CHECK(narrowed("<svg/>", 10) == "<svg/>");
  const std::string png = sample_png();
  CHECK(narrowed(png.substr(0, png.size() / 2), 1).size() > 0);
}
