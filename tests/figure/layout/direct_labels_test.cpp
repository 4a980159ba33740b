// Names on curves: each beside its own and off all others, or in a column beside the frame.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <tests/figure/samples.hpp>
#include "reports/figure/layout/layout.hpp"
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;
using samples::curve;

namespace {

double distance(Point p, Point q) { return std::hypot(p.x - q.x, p.y - q.y); }

// From a box to the nearest point of a trace, by points a tenth of a point apart.
double distance(const Box& box, const Trace& trace) {
  double least = 1e9;
  for (const Stroke& s : trace.strokes)
    for (std::size_t i = 0; i + 1 < s.size(); ++i) {
      const int steps = static_cast<int>(distance(s[i], s[i + 1]) / 0.1) + 1;
      for (int k = 0; k <= steps; ++k) {
        const double f = static_cast<double>(k) / steps;
        const Point p{s[i].x + f * (s[i + 1].x - s[i].x), s[i].y + f * (s[i + 1].y - s[i].y)};
        least = std::min(least, distance(p, {std::clamp(p.x, box.x, box.right()), std::clamp(p.y, box.y, box.bottom())}));
      }
    }
  return least;
}

PanelLayout laid_out(const Panel& panel) { return lay_out_panel(measuring_context().get(), panel, 190, 102, 230); }

}  // namespace

TEST_CASE("curves that end apart bear their names right of the frame, each as high as its curve ends") {
  Panel one = samples::panel({});
  for (int i = 0; i < 4; ++i)
    one.series.push_back(curve("l" + std::to_string(i + 1), 50, 10, [=](double t) { return 10.0 * i + 2 * t * (i - 2); }));
  const PanelLayout p = laid_out(one);
  CHECK(p.legend_place == PanelLayout::Place::none);
  REQUIRE(p.direct.labels.size() == 4);
  for (const DirectLabel& label : p.direct.labels) {
    CHECK(label.text == one.series[static_cast<std::size_t>(label.series)].label);
    CHECK(label.box.x >= p.frame.width);
    CHECK(label.box.right() <= p.frame.width + p.direct.right + 1e-9);
    const Point end = p.traces[static_cast<std::size_t>(label.series)].strokes.back().back();
    CHECK(std::abs(label.box.y + label.box.height / 2 - end.y) < 1);
  }
}

TEST_CASE("names at ends that are near each other move apart in their order, and leaders tell whose they are") {
  Panel one = samples::panel({});
  for (int i = 0; i < 3; ++i)
    one.series.push_back(
        curve("l" + std::to_string(i + 1), 50, 10, [=](double t) { return 50 * std::sin(0.3 * i * t) * (10 - t) + 12 * i; }));
  const PanelLayout p = laid_out(one);
  REQUIRE(p.direct.labels.size() == 3);
  REQUIRE(p.direct.right > 0);
  for (const DirectLabel& label : p.direct.labels) {
    const Point end = p.traces[static_cast<std::size_t>(label.series)].strokes.back().back();
    REQUIRE(label.leader.size() == 2);
    CHECK(label.leader.front().y == Approx(end.y));
    CHECK(label.leader.back().y == Approx(label.box.y + label.box.height / 2));
    for (const DirectLabel& other : p.direct.labels)
      if (other.series > label.series) {
        CHECK(std::abs(other.box.y - label.box.y) > 7);  // a line of 7 pt
        CHECK(other.box.y < label.box.y);                // l2 ends above l1
      }
  }
}

TEST_CASE("curves that end in one point bear their names where they are apart, nearer to their own than to any other") {
  std::mt19937_64 random(815);
  std::uniform_real_distribution<double> amplitude(5, 30), phase(-1, 1);
  std::uniform_int_distribution<int> count(2, 6);
  int inside = 0;
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    Panel one = samples::panel({});
    const int curves = count(random);
    for (int i = 0; i < curves; ++i) {
      const double a = amplitude(random), b = amplitude(random) * phase(random);
      one.series.push_back(curve("F" + std::to_string(i + 1), 200, 10, [=](double t) {
        const double s = std::numbers::pi * t / 10;
        return a * std::sin(2 * s) + b * std::sin(4 * s);
      }));
    }
    const PanelLayout p = laid_out(one);
    if (p.direct.labels.empty()) continue;
    ++inside;
    REQUIRE(static_cast<int>(p.direct.labels.size()) == curves);
    for (const DirectLabel& label : p.direct.labels) {
      CHECK((label.box.x >= 0 && label.box.y >= 0 && label.box.right() <= p.frame.width && label.box.bottom() <= p.frame.height));
      const double own = distance(label.box, p.traces[static_cast<std::size_t>(label.series)]);
      for (int i = 0; i < curves; ++i) {
        const double to = distance(label.box, p.traces[static_cast<std::size_t>(i)]);
        CHECK(to > 0);  // it covers no curve
        if (label.leader.empty() && i != label.series) CHECK(to > own);
      }
      for (const DirectLabel& other : p.direct.labels)
        if (other.series != label.series) CHECK(!label.box.overlaps(other.box));
    }
  }
  INFO(inside << " with names inside");
  CHECK(inside > 20);
}

TEST_CASE("curves that coincide throughout share a place, and both have their names") {
  const Panel one = samples::panel({curve("θ₁", 50, 10, [](double t) { return t; }), curve("θ₂", 50, 10, [](double t) { return 30 - t; }),
                                    curve("θ₃", 50, 10, [](double t) { return 30 - t; })});
  const PanelLayout p = laid_out(one);
  REQUIRE(p.direct.labels.size() == 3);
  const auto of = [&](int series) {
    return *std::find_if(p.direct.labels.begin(), p.direct.labels.end(), [=](const DirectLabel& l) { return l.series == series; });
  };
  CHECK(of(1).box.y == of(2).box.y);
  CHECK(of(2).box.x > of(1).box.right());
  CHECK(std::abs(of(0).box.y - of(1).box.y) > 7);
}

TEST_CASE("the legend has the names of many curves, and of those that nobody could tell apart at any place") {
  Panel many = samples::panel({}), tangled = samples::panel({});
  for (int i = 0; i < 7; ++i) many.series.push_back(curve("l" + std::to_string(i), 50, 10, [=](double t) { return i * t; }));
  for (int i = 0; i < 5; ++i)
    tangled.series.push_back(curve("l" + std::to_string(i), 4000, 10, [=](double t) { return std::sin(1e5 * t * t + i); }));
  for (const Panel& panel : {many, tangled}) {
    const PanelLayout p = laid_out(panel);
    CHECK(p.direct.labels.empty());
    REQUIRE(p.legend_place != PanelLayout::Place::none);
    std::size_t keys = 0;
    for (const Legend::Column& column : p.legend.columns) keys += column.keys.size();
    CHECK(keys == panel.series.size());
  }
}

TEST_CASE("where curves bear their names, the legend tells shadings alone") {
  Panel one = samples::panel({curve("l₁", 50, 10, [](double t) { return t; }), curve("l₂", 50, 10, [](double t) { return 30 - t; })});
  one.bands = {{1, 2, Band::Kind::limit}};
  const PanelLayout p = laid_out(one);
  CHECK(p.direct.labels.size() == 2);
  REQUIRE(p.legend.columns.size() == 1);
  REQUIRE(p.legend.columns[0].keys.size() == 1);
  CHECK(p.legend.columns[0].keys[0].label == "limit broken");
}

TEST_CASE("a name at its curve is the curve's key in an SVG") {
  const std::string svg = to_svg(samples::figure(
      {samples::panel({curve("l₁", 50, 10, [](double t) { return t; }), curve("l₂", 50, 10, [](double t) { return 30 - t; })})}));
  for (const char* key : {"<g class=\"key\" data-series=\"0\">", "<g class=\"key\" data-series=\"1\">"})
    CHECK(svg.find(key) != std::string::npos);
}
