#include "reports/figure/layout/range.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include <tests/figure/samples.hpp>
#include "reports/figure/shading.hpp"

using namespace pmreport::figure;
using samples::curve;
using samples::panel;

TEST_CASE("a range holds its data with a small margin") {
  const Interval y = y_range(panel({curve("a", 100, 10, [](double t) { return 600 + 3 * t; })}));
  CHECK(y.low < 600);
  CHECK(y.high > 630);
  CHECK(y.high - y.low < 1.2 * 30);
  const Interval x = x_range(panel({curve("a", 100, 10, [](double t) { return t; })}));
  CHECK(x.low == 0);
  CHECK(x.high == 10);
}

TEST_CASE("a constant curve lies in the middle of a sensible range") {
  for (const double value : {550.0, 0.0, -1e-12, 1e9}) {
    CAPTURE(value);
    const Interval y = y_range(panel({curve("a", 100, 10, [=](double) { return value; })}));
    CHECK(y.low < value);
    CHECK(y.high > value);
    CHECK(y.low / 2 + y.high / 2 == Approx(value).margin(1e-9 * (y.high - y.low)));
  }
}

TEST_CASE("rounding around a constant is not shown as a signal") {
  const Interval y = y_range(panel({curve("a", 100, 10, [](double t) { return 550 * (1 + 1e-15 * std::sin(40 * t)); })}));
  CHECK(y.high - y.low > 1);
}

TEST_CASE("a limit line is shown when it is near and left out when it is far") {
  Panel one = panel({curve("a", 100, 10, [](double t) { return 600 + 3 * t; })});
  one.lines = {{660, "near"}};
  CHECK(y_range(one).high > 660);
  one.lines = {{800, "far"}, {samples::gap, "none"}};
  CHECK(y_range(one).high < 640);
}

TEST_CASE("a spike at a singularity does not flatten the rest") {
  const auto near_singular = [](double t) { return std::sin(t) + 1e-4 / (t - 6.0003); };
  const Interval y = y_range(panel({curve("F", 5000, 10, near_singular)}));
  CHECK(y.high - y.low == Approx(2.3).margin(1));  // sin alone needs 2.2
  const Interval wild = y_range(panel({curve("F", 500, 10, [](double t) { return t > 5 && t < 5.1 ? 1e300 : std::sin(t); })}));
  CHECK(wild.high < 10);
  CHECK(wild.low == Approx(-1).margin(0.5));
}

TEST_CASE("one large curve among small ones is no spike") {
  std::vector<Series> series;
  for (int i = 0; i < 30; ++i) series.push_back(curve("a", 100, 10, [](double t) { return std::sin(t); }));
  series.push_back(curve("z", 100, 10, [](double t) { return 5000 + t; }));
  CHECK(y_range(panel(series)).high > 5010);
}

TEST_CASE("a pulse in a curve at rest is shown whole") {
  CHECK(y_range(panel({curve("a", 500, 10, [](double t) { return t > 5 && t < 5.1 ? 7.0 : 0.0; })})).high > 7);
}

TEST_CASE("a panel without finite data has an empty unit range") {
  const Panel none = panel({curve("a", 10, 10, [](double) { return samples::gap; })});
  CHECK(!has_data(none));
  CHECK(y_range(none).low == 0);
  CHECK(y_range(none).high == 1);
  CHECK(x_range(panel({})).high == 1);
}

TEST_CASE("bands merge, stay in the frame, and never vanish") {
  const Frame frame{100, 50, {0, 10}, {0, 1}};
  const std::vector<Band> bands{{2, 2, Band::Kind::limit},      {5, 4, Band::Kind::limit},   {4.5, 6, Band::Kind::limit},
                                {-5, -1, Band::Kind::limit},    {10, 10, Band::Kind::limit}, {samples::gap, 3, Band::Kind::limit},
                                {7, 8, Band::Kind::unreachable}};
  const std::vector<Box> boxes = band_boxes(bands, Band::Kind::limit, frame);
  REQUIRE(boxes.size() == 3);
  CHECK(boxes[0].width == Approx(1));
  CHECK(boxes[0].x + boxes[0].width / 2 == Approx(20));
  CHECK(boxes[1].x == Approx(40));
  CHECK(boxes[1].right() == Approx(60));
  CHECK(boxes[2].right() == Approx(100));
  CHECK(boxes[2].width == Approx(1));
  CHECK(band_boxes(bands, Band::Kind::unreachable, frame).size() == 1);
}
