// Small multiples, lines that forbid what lies beyond them, and marks.
#include <catch2/catch.hpp>

#include <cmath>

#include <tests/figure/samples.hpp>
#include "reports/figure/layout/layout.hpp"
#include "reports/figure/palette.hpp"
#include "reports/figure/surface.hpp"
#include "reports/figure/text.hpp"

using namespace pmreport::figure;
using samples::curve;

namespace {

Figure six_limbs() {
  Figure f = samples::figure({});
  f.multiples = Multiples{{}, {"length", "speed", "force", "power"}};
  for (int row = 0; row < 6; ++row) {
    f.multiples->rows.push_back("l" + std::to_string(row + 1));
    for (int column = 0; column < 4; ++column) {
      Panel p = samples::panel({curve("", 200, 2, [=](double t) { return (row + 1) * (column + 1) * std::sin(3 * t); })});
      p.series.front().style = row;
      p.marks = {{1, (row + 1) * (column + 1) * std::sin(3.0), "−1.2", row, row == 2}};
      f.panels.push_back(std::move(p));
    }
  }
  return f;
}

}  // namespace

TEST_CASE("panels of a column of small multiples stand below each other on one scale, and fit a page") {
  const Context cr = measuring_context();
  const Figure f = six_limbs();
  const Layout layout = lay_out(cr.get(), f);
  REQUIRE(layout.panels.size() == 24);
  CHECK(layout.size.width == Approx(493.228).margin(0.01));  // 174 mm
  CHECK(layout.size.height < 480);                           // of 700 pt that a page has
  for (std::size_t i = 0; i < 24; ++i) {
    const PanelLayout& p = layout.panels[i];
    const PanelLayout& top = layout.panels[i % 4];
    CHECK(p.y.low == top.y.low);
    CHECK(p.y.high == top.y.high);
    CHECK(p.y.high >= 6.0 * static_cast<double>(i % 4 + 1) * 0.99);  // the largest of the column
    CHECK(p.frame.x == top.frame.x);
    CHECK(p.frame.width == layout.panels[0].frame.width);
    CHECK(p.frame.y == layout.panels[i - i % 4].frame.y);
    CHECK(p.legend_place == PanelLayout::Place::none);
    CHECK(p.frame.right() <= layout.size.width);
    CHECK(p.heading.empty() == (i >= 4));
    CHECK(p.row_name == (i % 4 == 0 ? f.multiples->rows[i / 4] : ""));
    CHECK(p.x_numbered == (i >= 20));
    if (i >= 4) CHECK(p.frame.y > layout.panels[i - 4].frame.bottom());
  }
  CHECK(layout.panels[1].heading == "speed [mm]");
}

TEST_CASE("the number at the end of the last axis stands inside the picture, as wide as it is where frames are wider") {
  const Context cr = measuring_context();
  for (const double end : {2.0, 3.0, 0.7, 12.0, 100.0, 1e-3, 2e4}) {
    CAPTURE(end);
    Figure f = six_limbs();
    for (Panel& p : f.panels)
      for (double& x : p.series.front().x) x *= end / 2;
    const Layout layout = lay_out(cr.get(), f);
    const PanelLayout& last = layout.panels.back();
    REQUIRE_FALSE(last.x.major.empty());
    for (const Tick& tick : last.x.major) {
      const double middle = last.frame.x + last.x.position(tick.value) * last.frame.width;
      CHECK(middle + Text(cr.get(), tick.label, {.size = tick_size}).extents().width / 2 <= layout.size.width - 1);
    }
  }
}

TEST_CASE("a number beside a marked point stands inside the frame") {
  const Context cr = measuring_context();
  for (const PanelLayout& p : lay_out(cr.get(), six_limbs()).panels) {
    REQUIRE(p.mark_labels.size() == 1);
    const Box& b = p.mark_labels[0];
    CHECK((b.x >= 0 && b.y >= 0 && b.right() <= p.frame.width && b.bottom() <= p.frame.height));
    CHECK(b.width > 5);
  }
}

TEST_CASE("a worst point beyond the scale is marked at the frame's edge, with its number") {
  const Context cr = measuring_context();
  Figure f = six_limbs();
  for (std::size_t i = 0; i < f.panels.size(); i += 4) {
    f.panels[i].series[0].y[100] = 1e4;  // a spike, which the scale leaves out
    f.panels[i].marks = {{f.panels[i].series[0].x[100], 1e4, "10000", 0, false}};
  }
  const Layout layout = lay_out(cr.get(), f);
  for (std::size_t i = 0; i < f.panels.size(); i += 4) {
    const PanelLayout& p = layout.panels[i];
    CHECK(p.y.high < 1e3);
    REQUIRE(p.mark_labels.size() == 1);
    CHECK(p.mark_labels[0].width > 5);
    CHECK(p.mark_labels[0].y < 10);
  }
}

TEST_CASE("beyond a line that forbids it is hatched to the frame, and a line off the scale is told") {
  const Context cr = measuring_context();
  Panel one = samples::panel({curve("l₁", 50, 10, [](double t) { return 100 + t; })});
  one.lines = {{112, "stroke ends", Line::Forbids::above}, {98, "", Line::Forbids::below}};
  PanelLayout p = lay_out_panel(cr.get(), one, 190, 102, 230);
  REQUIRE(p.limit_bands.size() == 2);
  CHECK(p.limit_bands[0].y == 0);
  CHECK(p.limit_bands[0].bottom() == Approx(p.lines[0]));
  CHECK(p.limit_bands[1].y == Approx(p.lines[1]));
  CHECK(p.limit_bands[1].bottom() == Approx(102));
  CHECK(p.spike_note.empty());

  one.lines = {{760, "stroke ends", Line::Forbids::above}, {-300.5, "", Line::Forbids::below}};
  p = lay_out_panel(cr.get(), one, 190, 102, 230);
  CHECK(p.limit_bands.empty());
  CHECK(p.spike_note == "limits −300.5 to 760 mm off the scale");
  one.lines = {{760, "limit", Line::Forbids::above}, {-760, "limit", Line::Forbids::below}};
  CHECK(lay_out_panel(cr.get(), one, 190, 102, 230).spike_note == "limits ±760 mm off the scale");
  one.lines = {{760, "limit", Line::Forbids::above}, {98, "limit", Line::Forbids::below}};
  CHECK(lay_out_panel(cr.get(), one, 190, 102, 230).spike_note == "limit 760 mm off the scale");
}
