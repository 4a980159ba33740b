#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include <tests/figure/samples.hpp>
#include "reports/figure/layout/layout.hpp"
#include "reports/figure/layout/range.hpp"
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;
using samples::gap;

namespace {

Series points(std::vector<double> x, std::vector<double> y) { return {"machines", std::move(x), std::move(y), 0, true}; }

}  // namespace

TEST_CASE("a series of points has a dot at every sample that has both numbers, and no line") {
  const Panel p = samples::panel({points({1, 2, gap, 4, 5}, {10, 12, 11, gap, 40})});
  const PanelLayout layout = lay_out_panel(measuring_context().get(), p, 200, 100, 300);
  REQUIRE(layout.traces.size() == 1);
  CHECK(layout.traces[0].strokes.empty());
  CHECK(layout.traces[0].exits.empty());
  REQUIRE(layout.traces[0].dots.size() == 3);
  for (const Point dot : layout.traces[0].dots) {
    // All of a dot lies within the frame: a range of points has a margin on every side.
    CHECK(dot.x > 2);
    CHECK(dot.x < 198);
    CHECK(dot.y > 2);
    CHECK(dot.y < 98);
  }
}

TEST_CASE("a point that lies apart is shown, where a curve's spike would be cut off") {
  Series many = points({}, {});
  for (int k = 0; k < 100; ++k) many.x.push_back(k), many.y.push_back(k == 50 ? 1e6 : k % 7);
  CHECK(y_range(samples::panel({many})).high > 1e6);
  many.points = false;
  CHECK(y_range(samples::panel({many})).high < 1e6);
}

TEST_CASE("rows with names stand one above the other, each beside its own") {
  Panel p = samples::panel({points({3, 1, 2}, {0, 1, 2})});
  p.y = {"", "", {"Gough", "Stewart", "delta"}};
  const PanelLayout layout = lay_out_panel(measuring_context().get(), p, 200, 100, 300);
  REQUIRE(layout.y.major.size() == 3);
  REQUIRE(layout.traces[0].dots.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(layout.y.major[k].label == p.y.names[k]);
    CHECK(layout.traces[0].dots[k].y == Approx(100 * (1 - layout.y.position(layout.y.major[k].value))));
  }
  CHECK(layout.traces[0].dots[0].y > layout.traces[0].dots[1].y);
  CHECK(layout.traces[0].dots[1].y > layout.traces[0].dots[2].y);
}

TEST_CASE("the legend tells points from curves") {
  const Panel p = samples::panel({points({1}, {1}), samples::curve("curve", 5, 1, [](double t) { return t; })});
  const std::vector<Key> keys = keys_of(p);
  REQUIRE(keys.size() == 2);
  CHECK(keys[0].kind == Key::Kind::points);
  CHECK(keys[1].kind == Key::Kind::curve);
}
