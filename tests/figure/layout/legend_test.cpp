#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include <tests/figure/samples.hpp>
#include "reports/figure/layout/layout.hpp"
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;
using samples::curve;

namespace {

// By halving, down to pieces smaller than a hundredth of a point: slow, and nothing like the raster that chose the place.
bool crosses(Point p, Point q, const Box& box) {
  if (box.contains(p) || box.contains(q)) return true;
  if (std::max(p.x, q.x) < box.x || std::min(p.x, q.x) > box.right() || std::max(p.y, q.y) < box.y || std::min(p.y, q.y) > box.bottom())
    return false;
  if (std::hypot(q.x - p.x, q.y - p.y) < 0.01) return false;
  const Point middle{(p.x + q.x) / 2, (p.y + q.y) / 2};
  return crosses(p, middle, box) || crosses(middle, q, box);
}

bool covers_ink(const PanelLayout& panel, const Box& box) {
  for (const Trace& trace : panel.traces) {
    for (const Stroke& stroke : trace.strokes) {
      for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        if (crosses(stroke[i], stroke[i + 1], box)) return true;
      }
    }
    if (std::any_of(trace.dots.begin(), trace.dots.end(), [&](Point dot) { return box.contains(dot); })) return true;
  }
  return std::any_of(panel.line_labels.begin(), panel.line_labels.end(), [&](const LineLabel& label) { return label.box.overlaps(box); }) ||
         std::any_of(panel.lines.begin(), panel.lines.end(), [&](double y) {
           return crosses({0, y}, {panel.frame.width, y}, box);
         });
}

}  // namespace

TEST_CASE("a legend covers no curve, no limit line and no label") {
  std::mt19937_64 random(4711);
  std::uniform_real_distribution<double> amplitude(0.1, 30), frequency(0.1, 3), phase(0, 6.3);
  std::uniform_int_distribution<int> count(7, 9), samples_of(5, 400);  // fewer curves bear their names themselves
  const Context cr = measuring_context();
  int inside = 0, below = 0;
  for (int round = 0; round < 150; ++round) {
    CAPTURE(round);
    Panel one = samples::panel({});
    const int curves = count(random), points = samples_of(random);
    for (int i = 0; i < curves; ++i) {
      const double a = amplitude(random), w = frequency(random), p = phase(random);
      one.series.push_back(curve("F" + std::to_string(i), points, 10, [=](double t) { return a * std::sin(w * t + p); }));
    }
    if (round % 3 == 0) one.lines = {{25, "stroke ends"}, {-25, "stroke begins"}};
    if (round % 4 == 0) one.bands = {{2, 4, Band::Kind::limit}};
    const PanelLayout panel = lay_out_panel(cr.get(), one, 190, 102, 230);
    if (panel.legend_place == PanelLayout::Place::inside) {
      ++inside;
      const Box& box = panel.legend.box;
      CHECK(!covers_ink(panel, box));
      CHECK((box.x >= 0 && box.y >= 0 && box.right() <= panel.frame.width && box.bottom() <= panel.frame.height));
    } else {
      ++below;
      CHECK(panel.legend.box.width <= 230);
    }
  }
  INFO(inside << " inside, " << below << " below");
  CHECK(inside > 25);  // the loop did test something
}

TEST_CASE("a legend goes below when curves fill the panel") {
  const Context cr = measuring_context();
  Panel full = samples::panel({});
  for (int i = 0; i < 10; ++i) {
    full.series.push_back(
        curve("force of limb " + std::to_string(i), 4000, 10, [=](double t) { return (1 + 0.1 * i) * std::sin(1e5 * t * t); }));
  }
  Figure figure = samples::figure({full});
  figure.width = Width::column;
  const Layout layout = lay_out(cr.get(), figure);
  REQUIRE(layout.panels[0].legend_place == PanelLayout::Place::below);
  CHECK(layout.panels[0].legend.box.y > layout.panels[0].frame.height);
  CHECK(layout.panels[0].frame.y + layout.panels[0].legend.box.bottom() <= layout.size.height);
  CHECK(layout.panels[0].frame.x + layout.panels[0].legend.box.x >= 0);
}

TEST_CASE("each kind of band and each labelled curve has one key") {
  Panel one = samples::panel({curve("l₁", 10, 1, [](double t) { return t; }), curve("", 10, 1, [](double t) { return -t; })});
  one.bands = {{0, 0.1, Band::Kind::limit}, {0.2, 0.3, Band::Kind::limit}, {0.4, 0.5, Band::Kind::unreachable}};
  const std::vector<Key> keys = keys_of(one);
  REQUIRE(keys.size() == 3);
  CHECK(keys[0].label == "l₁");
  CHECK(keys[1].label == "limit broken");
  CHECK(keys[2].label == "out of reach");
}

TEST_CASE("panels of one figure stand in line and inside the page") {
  const Context cr = measuring_context();
  Figure figure = samples::six_panels();
  figure.panels[3].y.label = "a far longer name of an axis than the others have, so that it must wrap";
  for (const Width width : {Width::full, Width::column}) {
    figure.width = width;
    const std::size_t columns = width == Width::full ? 2 : 1;
    const Layout layout = lay_out(cr.get(), figure);
    CHECK(layout.size.width == Approx(width == Width::full ? 493.228 : 240.945).margin(0.01));  // 174 mm and 85 mm
    for (std::size_t i = 0; i < layout.panels.size(); ++i) {
      CAPTURE(i, columns);
      const Box& frame = layout.panels[i].frame;
      CHECK(frame.x == layout.panels[i % columns].frame.x);
      CHECK(frame.y == layout.panels[i - i % columns].frame.y);
      CHECK(frame.width == layout.panels[0].frame.width);
      CHECK(frame.height == layout.panels[0].frame.height);
      CHECK(frame.width > 0.7 * layout.size.width / static_cast<double>(columns));
      CHECK(frame.x + layout.panels[i].y_title_x >= 0);
      CHECK(frame.right() <= layout.size.width);
      CHECK(frame.bottom() < layout.size.height);
    }
    CHECK(size_of(figure).height == layout.size.height);
  }
}

TEST_CASE("what a clipped curve reaches is told beside the heading") {
  const Context cr = measuring_context();
  const Panel one = samples::panel({curve("F₁", 500, 10, [](double t) { return t > 5 && t < 5.1 ? 3.1e5 : std::sin(t); })});
  const PanelLayout panel = lay_out_panel(cr.get(), one, 190, 102, 230);
  CHECK(panel.spike_note == "▲ F₁ clipped, reaches 3.1×10⁵ mm");
  CHECK(panel.traces[0].exits.size() == 1);
  CHECK(lay_out_panel(cr.get(), samples::six_panels().panels[0], 190, 102, 230).spike_note.empty());
}
