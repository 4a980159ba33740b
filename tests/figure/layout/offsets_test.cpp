// Curves far apart that move little: what is drawn of them.
#include "reports/figure/layout/offsets.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include <tests/figure/samples.hpp>
#include "reports/figure/layout/range.hpp"

using namespace pmreport::figure;
using samples::curve;
using samples::gap;
using samples::panel;

namespace {

double height_of(const Series& series) {
  double low = INFINITY, high = -INFINITY;
  for (const double y : series.y)
    if (std::isfinite(y)) low = std::min(low, y), high = std::max(high, y);
  return high - low;
}

// x moves by 20 µm about 0, z about 66 mm.
Panel scan() {
  return panel({curve("x", 400, 0.1, [](double t) { return 0.01 * std::sin(60 * t); }),
                curve("z", 400, 0.1, [](double t) { return 66.0003 + 0.008 * std::cos(60 * t); })});
}

}  // namespace

TEST_CASE("curves that would be flat lines are set off, so that each fills its panel") {
  const Panel before = scan(), after = set_off(before);
  CHECK(after.series[0].label == "x");
  CHECK(after.series[1].label == "z − 66 mm");
  CHECK(after.y.label == "limb length − offset");
  const Interval shown = y_range(after);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(height_of(after.series[i]) == Approx(height_of(before.series[i])).epsilon(1e-9));  // moved, not stretched
    CHECK(height_of(after.series[i]) > 0.3 * (shown.high - shown.low));
  }
  // Labels and curves still say where the platform was.
  CHECK(after.series[1].y[0] + 66 == Approx(before.series[1].y[0]).epsilon(1e-14));
}

TEST_CASE("curves that can be seen to move stay where they are") {
  const Panel wide =
      panel({curve("x", 100, 1, [](double t) { return 40 * std::sin(6 * t); }), curve("z", 100, 1, [](double) { return 550.0; })});
  CHECK(set_off(wide).series[1].label == "z");
  CHECK(set_off(wide).y.label == wide.y.label);
}

TEST_CASE("where it matters not how far from zero curves are, they are set off when they would be low") {
  const auto moves = [](double t) { return 40 * std::sin(6 * t); };
  const Panel far = panel({curve("x", 100, 1, moves), curve("z", 100, 1, [&](double t) { return 550 + moves(t); })});
  CHECK(set_off(far).series[1].label == "z");
  CHECK(set_off(far, low_share).series[0].label == "x");
  CHECK(set_off(far, low_share).series[1].label == "z − 550 mm");
  const Panel again = set_off(set_off(far, low_share));
  CHECK(again.series[1].label == "z − 550 mm");
}

TEST_CASE("rest and rounding are no movement") {
  const Panel rest = panel(
      {curve("x", 100, 1, [](double) { return 0.0; }), curve("z", 100, 1, [](double t) { return 550 * (1 + 1e-15 * std::sin(40 * t)); })});
  CHECK(set_off(rest).series[1].label == "z");
}

TEST_CASE("a line that shares the axis keeps the curves on it") {
  Panel limited = scan();
  limited.lines = {{66.1, "limit"}};
  CHECK(set_off(limited).series[1].label == "z");
}

TEST_CASE("a curve that cannot tell its offset keeps its panel as it is") {
  Panel nameless = scan();
  nameless.series[1].label.clear();
  CHECK(set_off(nameless).series[1].y == nameless.series[1].y);
}

TEST_CASE("curves of given styles, which are compared, keep their sums") {
  Panel shares = scan();
  shares.series[0].style = 3;
  CHECK(set_off(shares).series[1].y == shares.series[1].y);
}

TEST_CASE("a curve without a value is left alone") {
  Panel with_gap = scan();
  with_gap.series.push_back(curve("y", 400, 0.1, [](double) { return gap; }));
  const Panel after = set_off(with_gap);
  CHECK(after.series[1].label == "z − 66 mm");
  CHECK(after.series[2].label == "y");
}

TEST_CASE("an offset below zero is added, and a plain number has no unit") {
  Panel down = scan();
  down.y.unit.clear();
  for (double& y : down.series[1].y) y = -y;
  CHECK(set_off(down).series[1].label == "z + 66");
}

TEST_CASE("limits beyond the axis of curves that are set off are told, and hatch nothing") {
  Panel p = scan();
  p.lines = {{0.5, "stroke ends", Line::Forbids::below}, {580, "stroke ends", Line::Forbids::above}};
  p.series[0] = curve("x", 400, 0.1, [](double t) { return 60 + 0.01 * std::sin(60 * t); });
  const Panel after = set_off(p);
  REQUIRE(after.series[0].label == "x − 60 mm");
  CHECK(after.lines.empty());
  CHECK(after.note == "limits 0.5 to 580 mm off the scale");
}
