#include <catch2/catch.hpp>
#include <reports/scene/look.hpp>
#include <reports/scene/vector/drawing.hpp>

using namespace pmreport::scene;
using Eigen::Vector3d;

namespace {

const Quality quality{800, 600, false, 2, 85};
const Camera from_the_front{{0, 0, 0}, 0, 0, 1};

// A labelled ball before a bar that shows through, a bent arrow and a translucent sheet in front of half the bar.
Scene still_life() {
  Scene scene;
  scene.solids = {ball({0, -0.2, 0}, 0.1, {1, 0.5f, 0}), cylinder({-0.3, 0, 0}, {0.3, 0, 0}, 0.03, {0, 0, 1}, 0.5f)};
  for (int k = 0; k < 8; ++k) {
    const auto at = [](double angle) { return Vector3d(0.15 * std::cos(angle), 0, 0.25 + 0.15 * std::sin(angle)); };
    scene.solids.push_back(cylinder(at(0.3 * k), at(0.3 * (k + 1.1)), 0.02, {1, 0, 1}));
  }
  scene.lines = {{{{-0.4, 0.1, 0}, {0.4, 0.1, 0}}, {0, 0, 0}, 2, 1}};
  scene.surfaces = {{{{0.1, -0.5, -0.2}, {0.3, -0.5, -0.2}, {0.3, -0.5, 0.2}, {0.1, -0.5, 0.2}}, {{0, 1, 2}, {0, 2, 3}}, {0, 1, 0, 0.3f}}};
  scene.labels = {{{0, -0.2, 0}, "A1", {0, 0, 0}}, {{0.2, -0.5, 0.2}, "a < b & \"c\"", {0, 0, 0}}};
  return scene;
}

std::vector<Stroke> dashed(const Drawing& d) {
  std::vector<Stroke> out;
  for (const Layer& layer : d.layers)
    for (const Stroke& s : layer.strokes)
      if (!s.dash.empty()) out.push_back(s);
  return out;
}

}  // namespace

TEST_CASE("a picture as vectors has the same bytes every time, and ids of its own") {
  const Drawing one = draw(still_life(), from_the_front, quality), other = draw(still_life(), from_the_front, quality);
  CHECK(to_pdf(one) == to_pdf(other));
  const std::string svg = to_svg(one, "pose-1", "a picture");
  CHECK(svg == to_svg(other, "pose-1", "a picture"));
  CHECK(to_png(one) == to_png(other));
  CHECK(svg.find("<title>a picture</title>") != std::string::npos);
  for (std::size_t at = svg.find(" id=\""); at != std::string::npos; at = svg.find(" id=\"", at + 1))
    CHECK(svg.compare(at, 14, " id=\"f-pose-1-") == 0);
  CHECK(svg.find("a &lt; b &amp; ") != std::string::npos);  // words that can be searched
}

TEST_CASE("a picture is as wide as it is printed, and its labels are 7 pt there") {
  const Drawing d = draw(still_life(), from_the_front, quality);
  CHECK(to_pdf(d).find("/MediaBox [ 0 0 240.9448") != std::string::npos);  // 85 mm
  CHECK(label_size(d.width, d.printed) * d.points_per_pixel() == Approx(7));
}

TEST_CASE("what shows through is dashed where it is hidden, and only there") {
  const Drawing d = draw(still_life(), from_the_front, quality);
  const std::vector<Stroke> hidden = dashed(d);
  REQUIRE_FALSE(hidden.empty());
  // The ball hides 120 px in the middle of the picture; the bar hides the line along its whole length and is no wider than 0.6 of it.
  for (const Stroke& s : hidden)
    for (const Eigen::Vector2d& p : s.points) {
      CAPTURE(p.transpose());
      CHECK(std::abs(p.y() - 300) <= 18.01);
      CHECK(std::abs(p.x() - 400) <= (s.color.b > 0.5f ? 60.01 : 180.01));
    }
  Scene opaque = still_life();
  opaque.solids[1].through = 0;
  opaque.lines[0].through = 0;
  CHECK(dashed(draw(opaque, from_the_front, quality)).empty());
}

TEST_CASE("the pieces of a bent bar are one: no line parts them") {
  Scene scene;
  for (const Solid& s : still_life().solids)
    if (s.color.r == 1 && s.color.b == 1) scene.solids.push_back(s);
  REQUIRE(scene.solids.size() == 8);
  const Drawing d = draw(scene, from_the_front, quality);
  REQUIRE(d.layers.size() == 1);
  CHECK(d.layers[0].strokes.size() == 1);
}

TEST_CASE("a translucent sheet covers what is behind it, and not what is in front") {
  const Drawing d = draw(still_life(), from_the_front, quality);
  const auto film = [](const Drawing& of) {
    double sum = 0;
    for (const Layer& layer : of.layers)
      if (layer.opacity < 1) sum += area(layer.areas.front().region);  // tones lie one over the other
    return sum;
  };
  const double whole = film(d);
  CHECK(whole == Approx(120 * 240).epsilon(0.01));
  Scene behind = still_life();
  for (Vector3d& p : behind.surfaces[0].points) p.y() = 0.5;
  // The bar, 36 px high, is in front of its whole width; so is a part of the arrow.
  CHECK(film(draw(behind, from_the_front, quality)) < whole - 120 * 35);
}

TEST_CASE("a drawing of nothing is an empty page") {
  const Drawing d = draw({}, from_the_front, quality);
  CHECK(d.layers.empty());
  CHECK(to_pdf(d).starts_with("%PDF"));
}
