#include <reports/figure/colour_scale.hpp>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <tests/figure/eyes.hpp>

using namespace pmreport::figure;
using eyes::difference, eyes::lab;

namespace {

ColourMap map_of(std::vector<double> values, ColourMap::Scale scale = ColourMap::Scale::sequential) {
  ColourMap map;
  map.values = std::move(values);
  map.scale = scale;
  return map;
}

std::vector<double> evenly(int count, double from, double to) {
  std::vector<double> out;
  for (int k = 0; k < count; ++k) out.push_back(from + (to - from) * k / (count - 1));
  return out;
}

}  // namespace

TEST_CASE("the even scale grows lighter at one pace, in grey and for every kind of eye") {
  for (const auto eye : eyes::all) {
    const double first = lab(sequential(0), eye).lightness, last = lab(sequential(1), eye).lightness;
    CHECK(last - first > 60);  // of 100
    for (int k = 0; k < 20; ++k) {
      CAPTURE(k, eye == nullptr);
      const double step = lab(sequential((k + 1) / 20.0), eye).lightness - lab(sequential(k / 20.0), eye).lightness;
      CHECK(step > 0.4 * (last - first) / 20);
      CHECK(step < 1.8 * (last - first) / 20);
    }
  }
  // What S. van der Walt and N. Smith published: entries 0, 51, 102, 153, 204 and 255 of 256.
  constexpr std::array<std::array<double, 3>, 6> published{{{0.267004, 0.004874, 0.329415},
                                                            {0.253935, 0.265254, 0.529983},
                                                            {0.163625, 0.471133, 0.558148},
                                                            {0.134692, 0.658636, 0.517649},
                                                            {0.477504, 0.821444, 0.318195},
                                                            {0.993248, 0.906157, 0.143936}}};
  for (std::size_t k = 0; k < published.size(); ++k) {
    const Colour c = sequential(static_cast<double>(k) / 5);
    CAPTURE(k);
    CHECK(c.red == Approx(published[k][0]).margin(1.0 / 255));
    CHECK(c.green == Approx(published[k][1]).margin(1.0 / 255));
    CHECK(c.blue == Approx(published[k][2]).margin(1.0 / 255));
  }
}

TEST_CASE("an even scale goes from the least value to the most, and a pole is cut off and told") {
  CHECK(colour_range(map_of(evenly(500, 3, 8))).low == 3);
  CHECK(colour_range(map_of(evenly(500, 3, 8))).high == 8);
  CHECK(beyond_the_colours(map_of(evenly(500, 3, 8))).empty());
  std::vector<double> pole = evenly(1000, 3, 8);
  pole.push_back(4000);
  CHECK(colour_range(map_of(pole)).low == 3);
  CHECK(colour_range(map_of(pole)).high == Approx(8).epsilon(0.02));
  CHECK(beyond_the_colours(map_of(pole)) == "beyond the colours: up to 4×10³");
  pole.push_back(-70);
  CHECK(beyond_the_colours(map_of(pole)) == "beyond the colours: down to −70, up to 4×10³");
  const Interval flat = colour_range(map_of({5, 5, 5}));
  CHECK(flat.low < 5);
  CHECK(flat.high > 5);
  CHECK(colour_range(map_of({std::nan("")})).low == -1);
}

TEST_CASE("a value has the colour of the step that it lies in, the ends included") {
  const ColourMap map = map_of(evenly(100, 0, 24));
  const Interval range = colour_range(map);
  for (int k = 0; k < colour_levels; ++k) {
    const Colour expected = sequential((k + 0.5) / colour_levels);
    for (const double inside : {0.01, 0.5, 0.99}) {
      const Colour seen = colour_of(map, range, k + inside);
      CHECK((seen.red == expected.red && seen.green == expected.green && seen.blue == expected.blue));
    }
  }
  CHECK(colour_of(map, range, 24).red == sequential(1 - 0.5 / colour_levels).red);
  CHECK(colour_of(map, range, 1e9).red == colour_of(map, range, 24).red);
  CHECK(colour_of(map, range, -1e9).blue == colour_of(map, range, 0).blue);
}

TEST_CASE("any two fills differ in grey print, and dark lines stand out from all of them") {
  constexpr int side = 144;  // [px] 16 mm; a multiple of most patterns
  std::vector<std::vector<double>> grey;
  for (int number = -1; number < classes; ++number) {
    std::vector<double> image;
    for (int r = 0; r < side; ++r)
      for (int c = 0; c < side; ++c) image.push_back(lab(fill_of(number, r, c), nullptr).lightness);
    CHECK(*std::min_element(image.begin(), image.end()) > 55);  // ink is 9
    grey.push_back(std::move(image));
  }
  // Alike would be: one brightness, and the same share of steps along each of four directions.
  const auto look = [&](const std::vector<double>& image) {
    std::array<double, 5> out{};
    for (int r = 1; r + 1 < side; ++r)
      for (int c = 1; c + 1 < side; ++c) {
        const auto at = [&](int row, int column) { return image[static_cast<std::size_t>(row * side + column)]; };
        const std::array<double, 5> here{at(r, c), std::abs(at(r, c) - at(r, c + 1)), std::abs(at(r, c) - at(r + 1, c)),
                                         std::abs(at(r, c) - at(r + 1, c + 1)), std::abs(at(r, c) - at(r + 1, c - 1))};
        for (std::size_t k = 0; k < 5; ++k) out[k] += here[k] / (side * side);
      }
    return out;
  };
  for (std::size_t i = 0; i < grey.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(i, j);
      const auto a = look(grey[i]), b = look(grey[j]);
      double apart = 0;
      for (std::size_t k = 0; k < 5; ++k) apart = std::max(apart, std::abs(a[k] - b[k]));
      CHECK(apart > 1.2);  // [of 100] half a just noticeable difference, over the whole field
    }
}

TEST_CASE("neighbouring classes differ in colour for every kind of eye") {
  for (const auto eye : eyes::all)
    for (int k = 0; k + 1 < classes; ++k) {
      CAPTURE(k, eye == nullptr);
      CHECK(difference(lab(fill_of(k, 5, 7), eye), lab(fill_of(k + 1, 5, 7), eye)) > 5);
    }
}
