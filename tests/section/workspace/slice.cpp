#include <reports/section/workspace/slice.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>

using namespace pmreport;
using namespace pmreport::section;
using std::numbers::pi;

namespace {

const std::array<Coordinate, 2> plane{Coordinate{"x", "", "m"}, Coordinate{"y", "", "m"}};

using Margin = std::function<double(double, double)>;
scan::Field sampled(std::vector<scan::Axis> axes, const std::vector<Margin>& margins) {
  scan::Field field{std::move(axes), {}};
  for (const Margin& margin : margins) {
    field.margins.emplace_back();
    for (std::size_t i = 0; i < field.axes[0].count; ++i)
      for (std::size_t j = 0; j < field.axes[1].count; ++j)
        field.margins.back().push_back(margin(field.axes[0].value(i), field.axes[1].value(j)));
  }
  return field;
}

std::vector<mechanics::PoseMargin> named(const std::vector<std::string>& names) {
  std::vector<mechanics::PoseMargin> out;
  for (const std::string& name : names) out.push_back({static_cast<int>(out.size()), name.ends_with('>'), name, 1e-12});
  return out;
}

// Within 0.6 m of the origin, and not left of -0.3 m; out of reach beyond 1 m.
const std::vector<Margin> disc{[](double x, double y) { return 1 - std::hypot(x, y); },
                               [](double x, double y) { return 0.36 - x * x - y * y; }, [](double x, double) { return x + 0.3; }};
const auto disc_names = named({"reach", "rho1>", "A1_deflection<"});
const std::vector<scan::Axis> wide{{0, -1, 1, 81}, {1, -0.8, 0.8, 65}};

const figure::NamedLine* line_called(const figure::Panel& panel, const std::string& label) {
  const auto at = std::ranges::find(panel.named, label, &figure::NamedLine::label);
  return at == panel.named.end() ? nullptr : &*at;
}

double length(const figure::NamedLine& line) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < line.x.size(); ++k)
    if (const double step = std::hypot(line.x[k + 1] - line.x[k], line.y[k + 1] - line.y[k]); std::isfinite(step)) sum += step;
  return sum;
}

double value_at(const figure::ColourMap& map, double x, double y) {
  const auto nearest = [](const std::vector<double>& ticks, double at) {
    return static_cast<std::size_t>(std::lround((at - ticks.front()) / (ticks[1] - ticks[0])));
  };
  return map.values[nearest(map.y, y) * map.x.size() + nearest(map.x, x)];
}

}  // namespace

TEST_CASE("a slice is filled by what refuses first, and bound by lines with the names of the limits") {
  const figure::Panel panel = slice_panel(sampled(wide, disc), plane, disc_names);
  CHECK(panel.equal);
  CHECK(panel.x.unit == "mm");
  REQUIRE(panel.map);
  CHECK(panel.map->classes == std::vector<std::string>{"accepted", "ρ₁ max", "A₁ deflection min", "other limits"});
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> x(-1, 1), y(-0.8, 0.8);
  for (int k = 0; k < 2000; ++k) {
    const double a = x(random), b = y(random), r = std::hypot(a, b);
    if (std::min({std::abs(r - 1), std::abs(r - 0.6), std::abs(a + 0.3)}) < 0.01) continue;  // [m] two steps of the map
    CAPTURE(a, b);
    const double seen = value_at(*panel.map, 1000 * a, 1000 * b);
    if (r > 1)
      CHECK(std::isnan(seen));
    else
      CHECK(seen == (r > 0.6 ? 1 : a < -0.3 ? 2 : 0));
  }
  REQUIRE(panel.named.size() == 2);  // the reach bounds nothing that is accepted
  const figure::NamedLine *arc = line_called(panel, "ρ₁ max"), *chord = line_called(panel, "A₁ deflection min");
  REQUIRE((arc && chord));
  for (std::size_t k = 0; k < arc->x.size(); ++k) {
    CHECK(std::hypot(arc->x[k], arc->y[k]) == Approx(600).margin(1));  // [mm] an eighth of the squared step over the radius
    CHECK(arc->x[k] > -300 - 25);                                      // a step of the grid
  }
  for (const double at : chord->x) CHECK(at == Approx(-300).margin(1e-6));
  CHECK(length(*arc) == Approx(600 * 2 * (pi - pi / 3)).epsilon(0.01));
  CHECK(length(*chord) == Approx(2 * std::sqrt(600.0 * 600 - 300 * 300)).epsilon(0.01));
}

TEST_CASE("axes that run downward show the same slice") {
  const figure::Panel upward = slice_panel(sampled(wide, disc), plane, disc_names);
  std::vector<scan::Axis> axes = wide;
  for (scan::Axis& a : axes) std::swap(a.from, a.to);
  const figure::Panel downward = slice_panel(sampled(axes, disc), plane, disc_names);
  REQUIRE(upward.map->values.size() == downward.map->values.size());
  std::size_t differing = 0;
  for (std::size_t k = 0; k < upward.map->values.size(); ++k)
    differing += upward.map->values[k] != downward.map->values[k] && !std::isnan(upward.map->values[k]);
  CHECK(differing < upward.map->values.size() / 1000);  // values of the axes differ by rounding, and so may points on a limit
  CHECK(upward.map->x.front() == Approx(downward.map->x.front()));
}

TEST_CASE("angle beside length has no common scale") {
  const std::array<Coordinate, 2> mixed{Coordinate{"x", "", "m"}, Coordinate{"alpha", "", "rad"}};
  const figure::Panel panel = slice_panel(sampled(wide, disc), mixed, disc_names);
  CHECK(!panel.equal);
  CHECK(panel.y.unit == "°");
  CHECK(panel.y.label == "α");
  CHECK(panel.map->y.back() == Approx(0.8 * 180 / pi));
}

TEST_CASE("a margin within its rounding is on its limit, and accepted") {
  std::vector<Margin> margins = disc;
  margins[2] = [](double, double) { return -1e-15; };
  const figure::Panel panel = slice_panel(sampled(wide, margins), plane, disc_names);
  CHECK(value_at(*panel.map, 0, 0) == 0);
}

TEST_CASE("of many limits those that refuse most have fills of their own, the same in all slices") {
  std::vector<Margin> margins{[](double, double) { return 1.0; }};
  std::vector<std::string> names{"reach"};
  for (int k = 1; k <= 20; ++k) {  // strips, the later the wider, from the left
    const double edge = -1 + 2.0 * k * (k + 1) / (21 * 22);
    margins.push_back([edge](double x, double) { return x - edge; });
    names.push_back("rho" + std::to_string(k) + "<");
  }
  const scan::Field field = sampled({{0, -1, 1, 463}, {1, 0, 1, 5}}, margins);
  const auto told = margins_to_tell({&field}, named(names));
  CHECK(told == std::vector<std::size_t>{11, 12, 13, 14, 15, 16, 17, 18, 19, 20});
  const figure::Panel panel = slice_panel(field, plane, named(names));
  CHECK(panel.map->classes.size() == 12);
  CHECK(panel.map->classes.back() == "other limits");
  CHECK(value_at(*panel.map, -999, 500) == 11);
  CHECK(*std::ranges::max_element(panel.map->values) == 11);
}

TEST_CASE("a limit is never filled as if it were accepted, however many there are") {
  // As many limits as there are fills besides that of what is accepted: the last must not begin again with its fill.
  std::vector<Margin> margins{[](double, double) { return 1.0; }};
  std::vector<std::string> names{"reach"};
  for (int k = 1; k <= 11; ++k) {
    const double edge = -0.9 + 0.1 * k;
    margins.push_back([edge](double x, double) { return x - edge; });
    names.push_back("rho" + std::to_string(k) + "<");
  }
  const scan::Field field = sampled({{0, -1, 1, 41}, {1, 0, 1, 5}}, margins);
  const figure::Panel panel = slice_panel(field, plane, named(names));
  for (const double v : panel.map->values) CHECK((v >= 0 && v < 12));
  CHECK(panel.map->classes.size() <= 12);
}

TEST_CASE("a slice as numbers has each point with what refuses it first") {
  const scan::Field field = sampled({{0, -1, 1, 3}, {1, 0, 0.5, 2}}, disc);
  const document::Data data = slice_data("slice", field, plane, disc_names);
  CHECK(data.headings == std::vector<std::string>{"refused_by", "x [m]", "y [m]"});
  CHECK(data.words[0] == std::vector<std::string>{"rho1>", "reach", "", "", "rho1>", "reach"});
  CHECK(data.columns[0] == std::vector<double>{-1, -1, 0, 0, 1, 1});
  CHECK(data.columns[1] == std::vector<double>{0, 0.5, 0, 0.5, 0, 0.5});
}

TEST_CASE("an index is shown row by row upward, on a scale that suits its signs") {
  const std::vector<scan::Axis> axes{{0, 0, 0.2, 3}, {1, 0.1, 0, 2}};  // the second runs downward
  const figure::Panel panel = index_panel(axes, {1, 2, 3, 4, std::nan(""), 6}, plane, {"condition", ""});
  CHECK((panel.map->scale == figure::ColourMap::Scale::sequential));
  CHECK(panel.map->missing == "refused");
  const std::vector<double> expected{2, 4, 6, 1, 3, std::nan("")};
  for (std::size_t k = 0; k < 6; ++k)
    CHECK((panel.map->values[k] == expected[k] || (std::isnan(expected[k]) && std::isnan(panel.map->values[k]))));
  CHECK((index_panel(axes, {1, -2, 3, 4, 5, 6}, plane, {"det", ""}).map->scale == figure::ColourMap::Scale::diverging));
  const figure::Panel counts = counts_panel(axes, {0, 2, 3, 4, 5, 91}, plane, 91);
  CHECK(std::isnan(counts.map->values[3]));
  CHECK(counts.map->values[0] == 2);
  CHECK(counts.map->bar.label == "accepted of 91");
}

TEST_CASE("what is largest along the other axes is what a look at every point finds") {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> pick(-9, 9);
  const std::vector<scan::Axis> axes{{0, 0, 1, 3}, {1, 0, 1, 4}, {2, 0, 1, 2}, {3, 0, 1, 5}};
  std::vector<double> value;
  for (int k = 0; k < 3 * 4 * 2 * 5; ++k) value.push_back(pick(random) == 9 ? std::nan("") : pick(random));
  for (const auto& [first, second] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 3}, {3, 0}, {2, 1}}) {
    CAPTURE(first, second);
    const std::vector<double> seen = largest_along_others(axes, value, first, second);
    REQUIRE(seen.size() == axes[first].count * axes[second].count);
    for (std::size_t a = 0; a < axes[first].count; ++a)
      for (std::size_t b = 0; b < axes[second].count; ++b) {
        double expected = -100;
        for (std::size_t k = 0; k < value.size(); ++k) {
          const std::array<std::size_t, 4> at{k / 40, k / 10 % 4, k / 5 % 2, k % 5};
          if (at[first] == a && at[second] == b && value[k] > expected) expected = value[k];
        }
        CHECK(seen[a * axes[second].count + b] == expected);
      }
  }
}

TEST_CASE("an outline is closed, also along the rim of the grid") {
  const scan::Field field = sampled({{0, 0, 1, 101}, {1, -1, 1, 201}}, {[](double x, double y) { return 0.6 - std::hypot(x, y); }});
  const figure::Panel panel = outline_panel(field.axes, field.margins[0], plane, "all");
  REQUIRE(panel.named.size() == 1);
  const figure::NamedLine& line = panel.named[0];
  CHECK(line.label == "all");
  CHECK(std::hypot(line.x.front() - line.x.back(), line.y.front() - line.y.back()) < 1e-9);
  CHECK(length(line) == Approx(600 * pi + 1200).epsilon(0.002));  // half a circle and its diameter
}

TEST_CASE("panels of another number of axes are refused") {
  const scan::Field field = sampled(wide, disc);
  CHECK_THROWS_AS(index_panel({field.axes[0]}, std::vector<double>(81, 1.0), plane, {}), std::invalid_argument);
  CHECK_THROWS_AS(index_panel({field.axes[0], {1, 0, 1, 1}}, std::vector<double>(81, 1.0), plane, {}), std::invalid_argument);
}
