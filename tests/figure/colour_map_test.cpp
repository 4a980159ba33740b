#include "reports/figure/colour_map.hpp"
#include <reports/figure/draw.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include <tests/figure/eyes.hpp>
#include <tests/figure/samples.hpp>
#include "reports/figure/colour_scale.hpp"
#include "reports/figure/layout/layout.hpp"
#include "reports/figure/layout/legend.hpp"
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;

namespace {

ColourMap sampled(int points, const std::function<double(double, double)>& f) {
  ColourMap map;
  for (int i = 0; i < points; ++i) map.x.push_back(-1 + 2.0 * i / (points - 1)), map.y.push_back(-1 + 2.0 * i / (points - 1));
  for (const double y : map.y)
    for (const double x : map.x) map.values.push_back(f(x, y));
  map.bar = {"det", ""};
  map.contour = "det = 0";
  return map;
}

const Frame square{100, 100, {-1, 1}, {-1, 1}};

Panel panel_of(ColourMap map) {
  Panel p;
  p.title = "map", p.x = {"x", "mm"}, p.y = {"y", "mm"};
  p.map = std::move(map);
  return p;
}

double lightness(const Colour& c) { return eyes::lab(c, nullptr).lightness; }

}  // namespace

TEST_CASE("the scale is lightest at zero and darkens steadily on both sides") {
  CHECK(lightness(diverging(0)) > 95);
  for (int k = 0; k < 50; ++k) {
    CHECK(lightness(diverging((k + 1) / 50.0)) < lightness(diverging(k / 50.0)));
    CHECK(lightness(diverging(-(k + 1) / 50.0)) < lightness(diverging(-k / 50.0)));
    CHECK(std::abs(lightness(diverging(k / 50.0)) - lightness(diverging(-k / 50.0))) < 12);  // of 100: neither side looks larger
  }
  CHECK(diverging(0.5).red > diverging(0.5).blue);
  CHECK(diverging(-0.5).blue > diverging(-0.5).red);
}

TEST_CASE("the contour of a circle is one closed stroke on the circle") {
  const auto contour = level_contour(sampled(61, [](double x, double y) { return x * x + y * y - 0.49; }), square);
  REQUIRE(contour.size() == 1);
  CHECK(std::hypot(contour[0].front().x - contour[0].back().x, contour[0].front().y - contour[0].back().y) < 1e-6);
  CHECK(contour[0].size() > 100);
  for (const Point p : contour[0]) {
    const double r = std::hypot(p.x - 50, p.y - 50);
    CHECK(r == Approx(35).margin(0.05));  // linear in a cell of 1/30: off by the eighth of its square over the radius, 0.01 pt
  }
}

TEST_CASE("the contour follows the level of its map, and the legend names it only where values lie on both sides of it") {
  ColourMap bowl = sampled(61, [](double x, double y) { return x * x + y * y; });
  bowl.scale = ColourMap::Scale::sequential;
  bowl.level = 0.49, bowl.contour = "0.49";
  const auto contour = level_contour(bowl, square);
  REQUIRE(contour.size() == 1);
  for (const Point p : contour[0]) CHECK(std::hypot(p.x - 50, p.y - 50) == Approx(35).margin(0.05));
  const auto named = [](const ColourMap& map) {
    const auto keys = keys_of(panel_of(map));
    return std::any_of(keys.begin(), keys.end(), [](const Key& k) { return k.kind == Key::Kind::contour; });
  };
  CHECK(named(bowl));
  bowl.level = 3;
  CHECK_FALSE(named(bowl));
  CHECK(level_contour(bowl, square).empty());
}

TEST_CASE("where a value is missing there is no contour, and none at a pole") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto half = level_contour(sampled(41, [&](double x, double y) { return y > 0 ? nan : x; }), square);
  REQUIRE(half.size() == 1);
  for (const Point p : half[0]) {
    CHECK(p.x == Approx(50));
    CHECK(p.y >= 50 - 1e-9);
  }
  // 1/x changes its sign beside values of 20 and more, which one value in fifty reaches.
  CHECK(level_contour(sampled(400, [](double x, double) { return 1 / x; }), square).empty());
}

TEST_CASE("alternating corners are joined as the value in their middle says, and no stroke crosses another") {
  const auto saddle = level_contour(sampled(2, [](double x, double y) { return x * y + 0.25; }), square);
  REQUIRE(saddle.size() == 2);
  // The middle is positive: each stroke cuts off a negative corner, upper left or lower right.
  for (const Stroke& s : saddle) CHECK(((s[0].x - 50) * (s[1].x - 50) > 0 && (s[0].y - 50) * (s[1].y - 50) > 0) == true);
}

TEST_CASE("the colours end where 98 of 100 values lie, and the panel tells how far the rest goes") {
  const ColourMap map = sampled(50, [](double x, double y) { return x > 0.99 && y > 0.99 ? 1000.0 : x; });
  CHECK(colour_range(map).high == Approx(1).epsilon(0.05));
  const Context cr = measuring_context();
  CHECK(lay_out_panel(cr.get(), panel_of(map), 150, 150, 180).spike_note == "beyond the colours: up to 1×10³");
  CHECK(lay_out_panel(cr.get(), panel_of(sampled(50, [](double, double) { return 0.0; })), 150, 150, 180).spike_note.empty());
}

TEST_CASE("a map explains its contour and what is out of reach below the frame, never over it") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ColourMap map = sampled(21, [&](double x, double y) { return x + y > 1 ? nan : x; });
  const std::vector<Key> keys = keys_of(panel_of(map));
  REQUIRE(keys.size() == 2);
  CHECK(keys[0].kind == Key::Kind::contour);
  CHECK(keys[0].label == "det = 0");
  CHECK(keys[1].kind == Key::Kind::fill);
  CHECK(keys[1].label == "out of reach");
  CHECK(keys[1].style == -1);
  const Context cr = measuring_context();
  CHECK((lay_out_panel(cr.get(), panel_of(map), 150, 150, 180).legend_place == PanelLayout::Place::below));
}

TEST_CASE("a map of classes names those that occur, has no bar, and tells what has none") {
  ColourMap map = sampled(21, [&](double x, double y) { return x + y > 1 ? samples::gap : x < 0 ? 0.0 : 2.0; });
  map.scale = ColourMap::Scale::classes;
  map.classes = {"accepted", "leg 1 too short", "leg 2 too long"};
  map.missing = "not examined";
  const std::vector<Key> keys = keys_of(panel_of(map));
  REQUIRE(keys.size() == 3);
  CHECK((keys[0].label == "accepted" && keys[0].style == 0));
  CHECK((keys[1].label == "leg 2 too long" && keys[1].style == 2));
  CHECK((keys[2].label == "not examined" && keys[2].style == -1));
  const Context cr = measuring_context();
  const PanelLayout layout = lay_out_panel(cr.get(), panel_of(map), 150, 150, 180);
  CHECK(bar_width(cr.get(), map, layout.bar, 150) == 0);
  CHECK(layout.spike_note.empty());
}

TEST_CASE("a map without a value says so") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Context cr = measuring_context();
  CHECK(lay_out_panel(cr.get(), panel_of(sampled(5, [&](double, double) { return nan; })), 150, 150, 180).empty);
}

TEST_CASE("a figure of maps is drawn whole, the same each time, and refers to nothing outside") {
  Figure f = samples::figure({panel_of(sampled(31, [](double x, double y) { return x - y * y; })),
                              panel_of(sampled(31, [](double x, double y) { return x + y < -1 ? samples::gap : x * y; }))});
  f.panels[0].series.push_back({"motion", {-0.5, 0, 0.5}, {0, 0.4, 0.1}, 1});
  const std::string svg = to_svg(f), pdf = to_pdf(f);
  CHECK(svg == to_svg(f));
  CHECK(pdf == to_pdf(f));
  CHECK(svg.find("data:image/png;base64") != std::string::npos);
  CHECK(svg.find("href=\"http") == std::string::npos);
  CHECK(pdf.size() < 200'000);  // both maps at 216 dots an inch, in steps of colour
  CHECK(svg.size() < 300'000);
}
