#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <reports/scene/renderer.hpp>

using namespace pmreport::scene;
using Eigen::Vector3d;

namespace {

// A square across the line of sight of the front view, at depth y; either winding.
Surface pane(double y, const Color& color, bool turned = false) {
  Surface s;
  s.points = {{-0.3, y, -0.3}, {0.3, y, -0.3}, {0.3, y, 0.3}, {-0.3, y, 0.3}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  if (turned)
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
  s.color = color;
  return s;
}

Solid ball(double y, double radius, const Color& color) {
  Solid s{};
  s.kind = Solid::Kind::ball, s.a = {0, y, 0}, s.radius = radius, s.color = color;
  return s;
}

constexpr Color red{0.9f, 0.1f, 0.1f, 0.4f}, blue{0.1f, 0.1f, 0.9f, 0.4f}, grey{0.6f, 0.6f, 0.6f, 1};
const Camera front{{0, 0, 0}, 0, 0, 1};

Image drawn(Scene scene, bool transparent = false) {
  scene.ground = -10;
  return render(scene, front, {100, 100, transparent, 2});
}

std::array<int, 4> middle(const Image& image) {
  const std::size_t at = 4 * static_cast<std::size_t>(50 * image.width + 50);
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

int redness(const Image& image) { return middle(image)[0] - middle(image)[2]; }

}  // namespace

TEST_CASE("a solid is seen through a translucent surface before it, and hides one behind it") {
  Scene before, behind, alone;
  alone.solids = {ball(0, 0.2, grey)};
  before = behind = alone;
  before.surfaces = {pane(-0.5, red)};
  behind.surfaces = {pane(0.5, red)};
  const auto bare = middle(drawn(alone)), seen = middle(drawn(before));
  CHECK(redness(drawn(before)) > 40);
  CHECK(seen[0] > bare[0] / 2);  // not hidden
  CHECK(middle(drawn(behind)) == bare);
}

TEST_CASE("a surface looks alike from both sides") {
  for (const float alpha : {0.4f, 1.0f}) {
    Color color = red;
    color.a = alpha;
    Scene one, other;
    one.surfaces = {pane(0, color)};
    other.surfaces = {pane(0, color, true)};
    CHECK((drawn(one).rgba == drawn(other).rgba));
  }
}

TEST_CASE("of two translucent surfaces the nearer tints more, in whatever order they are given") {
  Scene red_first, blue_first, red_near;
  red_first.surfaces = {pane(-0.2, blue), pane(0.2, red)};
  blue_first.surfaces = {pane(0.2, red), pane(-0.2, blue)};
  red_near.surfaces = {pane(-0.2, red), pane(0.2, blue)};
  CHECK((drawn(red_first).rgba == drawn(blue_first).rgba));
  CHECK(redness(drawn(red_first)) < -20);
  CHECK(redness(drawn(red_near)) > 20);
}

TEST_CASE("an opaque surface hides what is behind it and is hidden by what is before it") {
  Color opaque = red;
  opaque.a = 1;
  Scene scene;
  scene.surfaces = {pane(0, opaque), pane(0.3, blue)};
  CHECK(redness(drawn(scene)) > 80);
  const auto alone = middle(drawn(scene));
  scene.solids = {ball(0.5, 0.2, {0, 1, 0})};
  CHECK(middle(drawn(scene)) == alone);
  scene.solids = {ball(-0.5, 0.2, {0, 1, 0})};
  CHECK(middle(drawn(scene))[1] > middle(drawn(scene))[0]);
}

TEST_CASE("a transparent picture tells how much of the ground shows through, and two panes let less through than one") {
  Scene one, two;
  one.surfaces = {pane(0, red)};
  two.surfaces = {pane(-0.1, red), pane(0.1, red)};
  // Seen straight on nothing is added to the opacity; two let through the square of what one does. One step of 255, and one of the samples.
  CHECK(middle(drawn(one, true))[3] == Approx(255 * 0.4).margin(2));
  CHECK(middle(drawn(two, true))[3] == Approx(255 * (1 - 0.6 * 0.6)).margin(2));
  CHECK(redness(drawn(one, true)) > 100);
  CHECK(middle(drawn(one))[3] == 255);
  // Roots of light are mixed: w of white, r of the pane; by IEC 61966-2-1.
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const auto encoded = [](double l) { return l <= 0.0031308 ? 12.92 * l : 1.055 * std::pow(l, 1 / 2.4) - 0.055; };
  const auto pure = middle(drawn(one, true)), mixed = middle(drawn(one));
  for (std::size_t k = 0; k < 3; ++k) {
    const double root = 0.4 * std::sqrt(linear(pure[k] / 255.0)) + 0.6;
    CHECK(mixed[k] == Approx(255 * encoded(root * root)).margin(4));
  }
}

TEST_CASE("pictures with surfaces have no seams between tiles, and the same bytes each time") {
  Scene scene;
  scene.ground = -0.3;
  scene.solids = {ball(0, 0.15, grey)};
  Surface tent;
  tent.color = blue;
  for (int k = 0; k < 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12;
    tent.points.push_back({0.4 * std::cos(angle), 0.4 * std::sin(angle), -0.2});
    tent.triangles.push_back({k, (k + 1) % 12, 12});
  }
  tent.points.push_back({0, 0, 0.4});
  scene.surfaces = {tent};
  const Camera camera{{0, 0, 0}, 0.6, 0.5, 1.2};
  const Quality quality{120, 90, false, 2};
  const Image whole = Renderer(400).draw(scene, camera, quality);
  CHECK((Renderer(400).draw(scene, camera, quality).rgba == whole.rgba));
  const Image tiled = Renderer(100).draw(scene, camera, quality);
  int most = 0;
  for (std::size_t i = 0; i < whole.rgba.size(); ++i) most = std::max(most, std::abs(whole.rgba[i] - tiled.rgba[i]));
  CHECK(most <= 3);  // the last bit of each of the sheets that lie over one another
}

TEST_CASE("corners that are no numbers, or no points, are left out, and do no harm") {
  Scene scene;
  scene.solids = {ball(0, 0.2, grey)};
  const Image before = drawn(scene);
  Surface bad = pane(-0.5, red);
  bad.points[0].x() = std::nan("");
  bad.triangles = {{0, 1, 2}, {1, 2, 9}, {-1, 1, 2}};
  scene.surfaces = {bad, Surface{}};
  CHECK((drawn(scene).rgba == before.rgba));
}

TEST_CASE("the frame of a surface holds all its points") {
  Bounds bounds;
  include(bounds, pane(0.7, red));
  CHECK((bounds.low - Vector3d(-0.3, 0.7, -0.3)).norm() < 1e-12);
  CHECK((bounds.high - Vector3d(0.3, 0.7, 0.3)).norm() < 1e-12);
}
