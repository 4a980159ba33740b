#include <reports/figure/layout/layout.hpp>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include <tests/figure/samples.hpp>
#include "reports/figure/surface.hpp"

using namespace pmreport::figure;
using std::numbers::pi;

namespace {

const Frame square{200, 200, {-1, 1}, {-1, 1}};

NamedLine circle(std::string label, double x, double y, double radius) {
  NamedLine line{std::move(label), {}, {}};
  for (int k = 0; k <= 120; ++k) {
    line.x.push_back(x + radius * std::cos(2 * pi * k / 120));
    line.y.push_back(y + radius * std::sin(2 * pi * k / 120));
  }
  return line;
}

// The corners of the name's box, turned by the definition of a rotation on a page whose y runs downward.
bool in_box(const LineName& name, Point p) {
  const Point along{std::cos(name.angle), std::sin(name.angle)}, across{-std::sin(name.angle), std::cos(name.angle)};
  const double x = p.x - name.middle.x, y = p.y - name.middle.y;
  return std::abs(x * along.x + y * along.y) < name.width / 2 && std::abs(x * across.x + y * across.y) < name.height / 2;
}

template <class Visit>
void walk(const Stroke& stroke, Visit&& visit) {
  for (std::size_t i = 0; i + 1 < stroke.size(); ++i)
    for (int k = 0; k <= 40; ++k)
      visit(Point{stroke[i].x + (stroke[i + 1].x - stroke[i].x) * k / 40, stroke[i].y + (stroke[i + 1].y - stroke[i].y) * k / 40});
}

double distance_to(const Stroke& stroke, Point p) {
  double least = 1e9;
  walk(stroke, [&](Point q) { least = std::min(least, std::hypot(p.x - q.x, p.y - q.y)); });
  return least;
}

}  // namespace

TEST_CASE("names on random lines cover no line, no end of one and no other name, and stand by their own") {
  std::mt19937_64 random(20240);
  std::uniform_real_distribution<double> place(-0.9, 0.9), radius(0.05, 0.9);
  std::uniform_int_distribution<int> count(1, 9);
  const Context cr = measuring_context();
  int placed = 0, told_by_legend = 0;
  for (int round = 0; round < 25; ++round) {
    CAPTURE(round);
    std::vector<NamedLine> lines;
    const int n = count(random);
    for (int k = 0; k < n; ++k) lines.push_back(circle("ρ" + std::to_string(k) + "<", place(random), place(random), radius(random)));
    const NamedLines out = lay_out_named(cr.get(), lines, square, {});
    REQUIRE(out.lines.size() == lines.size());
    for (std::size_t k = 0; k < lines.size(); ++k) {
      CAPTURE(k);
      const bool has_name = std::any_of(out.names.begin(), out.names.end(), [&](const LineName& m) { return m.text == lines[k].label; });
      CHECK(has_name == (out.lines[k].dash == 0));
      (has_name ? placed : told_by_legend) += 1;
    }
    for (std::size_t i = 0; i < out.names.size(); ++i) {
      const LineName& name = out.names[i];
      CAPTURE(name.text);
      CHECK(std::abs(name.angle) <= pi / 2);
      double nearest = 1e9, nearest_own = 1e9;
      for (std::size_t k = 0; k < lines.size(); ++k)
        for (const Stroke& stroke : out.lines[k].strokes) {
          bool covered = false;
          walk(stroke, [&](Point p) { covered = covered || in_box(name, p); });
          CHECK(!covered);
        }
      for (std::size_t k = 0; k < lines.size(); ++k)
        for (const Stroke& stroke : trace(lines[k].x, lines[k].y, square).strokes) {
          double& least = lines[k].label == name.text ? nearest_own : nearest;
          least = std::min(least, distance_to(stroke, name.middle));
        }
      CHECK(nearest_own < nearest);
      CHECK(nearest_own < 25);  // beside its line at most half its length away
      for (std::size_t j = 0; j < i; ++j)
        for (int u = -4; u <= 4; ++u)
          for (int v = -2; v <= 2; ++v) {
            const double x = name.width * u / 8, y = name.height * v / 4, c = std::cos(name.angle), s = std::sin(name.angle);
            CHECK(!in_box(out.names[j], {name.middle.x + c * x - s * y, name.middle.y + s * x + c * y}));
          }
    }
  }
  INFO(placed << " placed, " << told_by_legend << " in the legend");
  CHECK(placed > 60);
}

TEST_CASE("a straight line bears its name in its middle and along it, and is cut there") {
  const Context cr = measuring_context();
  for (const double slope : {0.0, 0.5, -0.8}) {
    CAPTURE(slope);
    const NamedLines out = lay_out_named(cr.get(), {{"stroke ends", {-0.9, 0.9}, {-0.9 * slope, 0.9 * slope}}}, square, {});
    REQUIRE(out.names.size() == 1);
    CHECK(out.names[0].angle == Approx(-std::atan(slope)));
    CHECK(out.names[0].middle.x == Approx(100).margin(2));  // places are tried every 2 pt
    CHECK(out.names[0].middle.y == Approx(100).margin(2));
    REQUIRE(out.lines[0].strokes.size() == 2);
  }
}

TEST_CASE("where no name finds room the line is dashed and the legend tells it") {
  const Context cr = measuring_context();
  Panel one = samples::panel({});
  one.equal = true;
  for (int k = 0; k < 40; ++k) one.named.push_back({"limit", {-1, 1}, {-1 + k / 20.0, -1 + k / 20.0}});
  const PanelLayout layout = lay_out_panel(cr.get(), one, 150, 150, 200);
  CHECK(layout.named.names.empty());
  REQUIRE((layout.legend_place == PanelLayout::Place::below));
  std::size_t keys = 0;
  for (const Legend::Column& column : layout.legend.columns) keys += column.keys.size();
  CHECK(keys == 40);
  one.named.resize(1);
  CHECK((lay_out_panel(cr.get(), one, 150, 150, 200).legend_place == PanelLayout::Place::none));
}

TEST_CASE("a line without a name keeps whole, and one outside the frame is not there") {
  const Context cr = measuring_context();
  const NamedLines out =
      lay_out_named(cr.get(), {circle("", 0, 0, 0.5), circle("far", 9, 9, 0.5), {"gone", {samples::gap}, {1}}}, square, {});
  CHECK(out.names.empty());
  REQUIRE(out.lines[0].strokes.size() == 1);
  CHECK(out.lines[1].strokes.empty());
  CHECK((out.lines[0].dash == 0 && out.lines[1].dash == 0 && out.lines[2].dash == 0));
}
