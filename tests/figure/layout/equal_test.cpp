#include <reports/figure/draw.hpp>
#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/range.hpp>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <tests/figure/samples.hpp>
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;

namespace {

Panel box(double width, double height, bool with_map) {
  Panel p;
  p.title = "slice", p.x = {"x", "mm"}, p.y = {"y", "mm"};
  p.equal = true;
  p.named.push_back({"rim", {0, width, width, 0, 0}, {0, 0, height, height, 0}});
  if (with_map) {
    ColourMap map;
    for (int k = 0; k < 5; ++k) map.x.push_back(width * k / 4), map.y.push_back(height * k / 4);
    for (int k = 0; k < 25; ++k) map.values.push_back(k % 3);
    map.scale = ColourMap::Scale::classes;
    map.classes = {"accepted", "a limit whose name is so long that the legend is wider than any frame", "another"};
    p.map = map;
  }
  return p;
}

}  // namespace

TEST_CASE("a step of x is as long as one of y, whatever the proportions, and nothing leaves the page") {
  std::mt19937_64 random(99);
  std::uniform_real_distribution<double> decade(-2, 4);
  const Context cr = measuring_context();
  for (int round = 0; round < 30; ++round) {
    Figure f = samples::figure({});
    f.width = round % 2 == 0 ? Width::full : Width::column;
    f.columns = 1 + round % 3;
    for (int k = 0; k <= round % 4; ++k) f.panels.push_back(box(std::pow(10, decade(random)), std::pow(10, decade(random)), k % 2 == 0));
    const Layout layout = lay_out(cr.get(), f);
    for (std::size_t i = 0; i < f.panels.size(); ++i) {
      const PanelLayout& p = layout.panels[i];
      const NamedLine& rim = f.panels[i].named[0];
      CAPTURE(round, i, rim.x[1], rim.y[2], p.frame.width, p.frame.height);
      CHECK(p.frame.width / (p.window.x.high - p.window.x.low) ==
            Approx(p.frame.height / (p.window.y.high - p.window.y.low)).epsilon(1e-9));
      CHECK((p.window.x.low <= 0 && p.window.x.high >= rim.x[1] && p.window.y.low <= 0 && p.window.y.high >= rim.y[2]));
      CHECK((p.frame.x + p.y_title_x >= 0 && p.frame.right() <= layout.size.width && p.frame.bottom() < layout.size.height));
      CHECK((p.frame.width >= 40 && p.frame.height >= 40));
      if (p.legend_place != PanelLayout::Place::below) continue;
      CHECK(p.frame.x + p.legend.box.x >= 0);
      CHECK(p.frame.x + p.legend.box.right() <= layout.size.width);
      CHECK(p.frame.y + p.legend.box.bottom() <= layout.size.height);
    }
    // Panels side by side keep off one another.
    const auto columns = static_cast<std::size_t>(f.width == Width::full ? std::min<int>(f.columns, static_cast<int>(f.panels.size())) : 1);
    for (std::size_t i = 0; i + 1 < f.panels.size(); ++i)
      if (i % columns + 1 < columns) CHECK(layout.panels[i].frame.right() <= layout.panels[i + 1].frame.x + layout.panels[i + 1].y_title_x);
  }
}

TEST_CASE("a square is drawn square and as large as the page allows") {
  const Context cr = measuring_context();
  Figure f = samples::figure({box(3, 3, true), box(3, 3, true)});
  const Layout layout = lay_out(cr.get(), f);
  for (const PanelLayout& p : layout.panels) {
    CHECK(p.frame.width == Approx(p.frame.height));
    CHECK(p.frame.width > 180);  // of 246 pt a panel, less the numbers and the title on the left
  }
}

TEST_CASE("curves to one scale keep off the frame, and the legend off the curves") {
  const Context cr = measuring_context();
  Panel p = box(2, 1, false);
  p.series.push_back(samples::curve("path", 100, 2, [](double t) { return 0.5 + 0.4 * std::sin(3 * t); }));
  const PanelLayout layout = lay_out_panel(cr.get(), p, 200, 200, 220);
  CHECK(layout.window.x.low == Approx(-0.1));
  CHECK(layout.window.x.high == Approx(2.1));
  CHECK(layout.window.y.high == Approx(1.05));
  CHECK(layout.frame.height == Approx(100));
}
