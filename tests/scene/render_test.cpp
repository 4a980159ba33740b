#include <catch2/catch.hpp>
#include <cstdlib>
#include <numbers>
#include <reports/scene/renderer.hpp>
#include <thread>

using namespace pmreport::scene;
using Eigen::Vector3d;

namespace {

Solid ball_at(const Vector3d& centre, double radius, const Color& color) {
  Solid s{};
  s.kind = Solid::Kind::ball, s.a = centre, s.radius = radius, s.color = color;
  return s;
}
Solid bar(Solid::Kind kind, const Vector3d& a, const Vector3d& b, double radius, const Color& color) {
  Solid s{};
  s.kind = kind, s.a = a, s.b = b, s.radius = radius, s.color = color;
  return s;
}

// One of everything, across the picture.
Scene assorted() {
  Scene scene;
  scene.solids = {ball_at({0.2, 0.1, 0.3}, 0.08, {0.9f, 0.5f, 0.1f}),
                  bar(Solid::Kind::cylinder, {-0.4, 0, 0}, {0.3, 0.2, 0.5}, 0.04, {0.5f, 0.5f, 0.5f}),
                  bar(Solid::Kind::cone, {0, -0.2, 0.1}, {0.1, -0.2, 0.5}, 0.06, {0.2f, 0.4f, 0.8f}),
                  bar(Solid::Kind::box, {-0.3, -0.3, 0.1}, {0.1, 0.08, 0.05}, 0, {0.3f, 0.7f, 0.4f})};
  Solid plate{};
  plate.kind = Solid::Kind::plate, plate.radius = 0.04, plate.color = {0.3f, 0.35f, 0.4f};
  plate.outline = {{-0.5, -0.4, 0}, {0.5, -0.4, 0}, {0.5, 0.4, 0}, {-0.5, 0.4, 0}};
  scene.solids.push_back(plate);
  scene.solids[2].through = 0.4f;
  scene.lines = {{{{-0.5, 0.3, 0.2}, {0, 0.3, 0.4}, {0.5, 0.2, 0.2}}, {0.8f, 0.2f, 0.1f}, 2.5, 0.3f}};
  scene.labels = {{{0.2, 0.1, 0.3}, "A1", {0, 0, 0}}, {{-0.3, -0.3, 0.1}, "B12", {0, 0, 0}}};
  scene.ground = -0.02;
  return scene;
}
const Camera isometric{{0, 0, 0.2}, 35 * std::numbers::pi / 180, 27 * std::numbers::pi / 180, 1.3};

const std::uint8_t* pixel(const Image& image, int x, int y) { return &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)]; }

}  // namespace

TEST_CASE("a ball lights the pixels where its centre is projected, in its own hue, and no others") {
  const Vector3d centre(0.21, -0.13, 0.34);
  for (const double azimuth : {0.0, 0.7, -2.0})
    for (const double elevation : {0.0, 0.5, 1.57}) {
      CAPTURE(azimuth, elevation);
      const Camera camera{{0, 0, 0.2}, azimuth, elevation, 1.2};
      Scene scene;
      scene.ground = -10;
      scene.solids = {ball_at(centre, 0.05, {0.9f, 0.2f, 0.1f})};
      const Image image = render(scene, camera, {320, 240, true, 2});
      const Eigen::Vector2d seen = project(camera, centre, 320, 240);
      const std::uint8_t* p = pixel(image, static_cast<int>(seen.x()), static_cast<int>(seen.y()));
      CHECK(p[3] == 255);
      CHECK(p[0] > 100);
      CHECK(p[0] > 1.8 * p[1]);
      CHECK(p[0] > 1.8 * p[2]);

      // Weighted by coverage, the pixels that belong to the ball (the ground is far below) have its centre and its area.
      double sum = 0, x = 0, y = 0;
      const double r = 0.05 * 240 / 1.2;
      for (int row = 0; row < 240; ++row)
        for (int column = 0; column < 320; ++column) {
          if ((Eigen::Vector2d(column + 0.5, row + 0.5) - seen).norm() > r + 6) continue;
          const double a = pixel(image, column, row)[3];
          if (a < 100) continue;  // shadow and grid are fainter
          sum += a / 255, x += a / 255 * (column + 0.5), y += a / 255 * (row + 0.5);
        }
      CHECK(std::abs(x / sum - seen.x()) < 0.25);  // [px]
      CHECK(std::abs(y / sum - seen.y()) < 0.25);
      const double outlined = std::numbers::pi * (r + 1.1) * (r + 1.1);  // the outline is 1.1 px wide
      CHECK(sum == Approx(outlined).epsilon(0.05));
    }
}

TEST_CASE("what is nearer covers what is farther, unless that is to be seen through it") {
  Scene scene;
  scene.ground = -10;
  scene.solids = {ball_at({0, -0.3, 0}, 0.2, {0.1f, 0.1f, 0.9f}), ball_at({0, 0.3, 0}, 0.1, {0.9f, 0.1f, 0.1f})};
  const Camera front{{0, 0, 0}, 0, 0, 1};
  const Image covered = render(scene, front, {100, 100, false, 2});
  CHECK(pixel(covered, 50, 50)[2] > 2 * pixel(covered, 50, 50)[0]);
  scene.solids[1].through = 0.9f;
  const Image through = render(scene, front, {100, 100, false, 2});
  CHECK(pixel(through, 50, 50)[0] > 2 * pixel(through, 50, 50)[2]);
}

TEST_CASE("a ghost tints what is behind it by its nearest surface alone, hides what is not, and casts no shadow") {
  const Camera front{{0, 0, 0}, 0, 0.35, 1};
  const Quality small{200, 150, false, 2};
  const Color red{0.9f, 0.1f, 0.1f}, blue{0.1f, 0.1f, 0.9f}, pale{0.1f, 0.1f, 0.9f, 0.3f};
  const auto middle = [&](const std::vector<Solid>& solids) {
    Scene scene;
    scene.solids = solids;
    scene.ground = -1;
    const Image image = render(scene, front, small);
    const std::uint8_t* p = pixel(image, 100, 75);
    return Eigen::Vector3i(p[0], p[1], p[2]);
  };
  const Solid far = ball_at({0, 0.3, 0}, 0.2, red);
  const Eigen::Vector3i alone = middle({far}), tinted = middle({far, ball_at({0, 0, 0}, 0.1, pale)}),
                        covered = middle({far, ball_at({0, 0, 0}, 0.1, blue)});
  CHECK(tinted[0] < alone[0]);
  CHECK(tinted[0] > covered[0]);
  CHECK(tinted[2] > alone[2]);
  CHECK(tinted[2] < covered[2]);
  // Two ghosts in a line are one tint, in whatever order they are given.
  const Solid nearer = ball_at({0, -0.05, 0}, 0.1, pale);
  const Eigen::Vector3i twice = middle({far, ball_at({0, 0, 0}, 0.1, pale), nearer}),
                        other = middle({nearer, far, ball_at({0, 0, 0}, 0.1, pale)});
  CHECK((twice - tinted).cwiseAbs().maxCoeff() < (tinted - alone).cwiseAbs().maxCoeff() / 4);  // the nearer one's light is another
  CHECK((twice - other).cwiseAbs().maxCoeff() <= 1);
  // Behind a solid there is none of it.
  CHECK((middle({ball_at({0, -0.5, 0}, 0.3, red), nearer}) == middle({ball_at({0, -0.5, 0}, 0.3, red)})));

  Scene shadow;
  shadow.solids = {ball_at({0, 0, 0.3}, 0.1, pale), ball_at({5, 0, 0}, 0.1, red)};
  const Camera above{{0, 0, 0}, 0, 1.5, 2};
  const Image with = render(shadow, above, small);
  shadow.solids.erase(shadow.solids.begin());
  const Image without = render(shadow, above, small);
  int darker = 0;
  for (int y = 0; y < 150; ++y)
    for (int x = 0; x < 200; ++x) {
      const Vector3d centre(0, 0, 0.3);
      if ((project(above, centre, 200, 150) - Eigen::Vector2d(x + 0.5, y + 0.5)).norm() < 12) continue;  // the ball itself
      darker += pixel(with, x, y)[0] + 2 < pixel(without, x, y)[0] ? 1 : 0;
    }
  CHECK(darker == 0);
}

TEST_CASE("two pictures of one scene have the same bytes, also from another thread, also after another picture") {
  const Image first = render(assorted(), isometric, {400, 300, false, 2});
  render(assorted(), {{0, 0, 0}, 0, 0, 3}, {100, 80, true, 1});
  const Image again = render(assorted(), isometric, {400, 300, false, 2});
  Image elsewhere;
  std::thread([&] { elsewhere = render(assorted(), isometric, {400, 300, false, 2}); }).join();
  CHECK((first.rgba == again.rgba));
  CHECK((first.rgba == elsewhere.rgba));
}

TEST_CASE("a picture drawn in small tiles shows no seams") {
  const Quality quality{400, 300, false, 2};
  const Image whole = Renderer(1000).draw(assorted(), isometric, quality);
  for (const int tile : {64, 130, 400}) {
    CAPTURE(tile);
    const Image tiled = Renderer(tile).draw(assorted(), isometric, quality);
    REQUIRE(tiled.rgba.size() == whole.rgba.size());
    int most = 0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
      const int d = std::abs(whole.rgba[i] - tiled.rgba[i]);
      most = std::max(most, d), differing += d > 0;
    }
    INFO(differing << " bytes differ, by at most " << most);
    // The rasteriser steps its interpolation from the corner of each tile: the last bit of a colour may fall either way, coverage may not.
    CHECK(most <= 2);
    CHECK(differing < whole.rgba.size() / 100);
  }
}

TEST_CASE("the ground of a picture is white or transparent as asked") {
  Scene scene = assorted();
  for (const auto& [transparent, alpha] : {std::pair{true, 0}, std::pair{false, 255}}) {
    const Image image = render(scene, {{0, 0, 0.2}, 0.6, 0.47, 4}, {200, 150, transparent, 2});
    for (const auto& [x, y] : {std::pair{0, 0}, std::pair{199, 0}, std::pair{0, 149}, std::pair{199, 149}}) {
      const std::uint8_t* p = pixel(image, x, y);
      CAPTURE(transparent, x, y);
      CHECK(int(p[3]) == alpha);
      if (!transparent) CHECK((p[0] == 255 && p[1] == 255 && p[2] == 255));
    }
  }
}

TEST_CASE("a shadow darkens the ground beside what casts it") {
  Scene scene;
  scene.ground = 0;
  scene.grid = 100;  // no line in sight but the two axes
  const Camera camera{{0, 0, 0.2}, 0, 0.5, 1.2};
  const Image bare = render(scene, camera, {200, 150, false, 2});
  scene.solids = {ball_at({0.1, 0.1, 0.12}, 0.1, {0.5f, 0.5f, 0.5f})};
  const Image shaded = render(scene, camera, {200, 150, false, 2});
  // Light falls from the left of the viewer: the shadow lies to the right of the ball's foot.
  const Eigen::Vector2d spot = project(camera, {0.1 + 0.3 * 0.12 + 0.05, 0.1, 0}, 200, 150);
  const int x = static_cast<int>(spot.x()), y = static_cast<int>(spot.y());
  CHECK(pixel(shaded, x, y)[1] < pixel(bare, x, y)[1] - 15);
}

TEST_CASE("sizes that OpenGL cannot draw are refused with both numbers") {
  CHECK_THROWS_WITH(render(assorted(), isometric, {40000, 300, false, 2}), Catch::Contains("40000 x 300") && Catch::Contains("16384"));
  CHECK_THROWS_AS(render(assorted(), isometric, {0, 300, false, 2}), std::runtime_error);
  CHECK_THROWS_AS(render(assorted(), isometric, {300, 200, false, 0}), std::runtime_error);
  CHECK(render(assorted(), isometric, {64, 48, false, 2}).rgba.size() == 64 * 48 * 4);
}

TEST_CASE("shapes without extent are left out, and do no harm") {
  Scene scene = assorted();
  const Image before = render(scene, isometric, {200, 150, false, 2});
  Solid flat{};
  flat.kind = Solid::Kind::plate, flat.outline = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, flat.radius = 0.1;
  scene.solids.insert(scene.solids.end(),
                      {flat, ball_at({0, 0, 0}, 0, {1, 1, 1}), bar(Solid::Kind::cylinder, {0, 0, 0.1}, {0, 0, 0.1}, 0.1, {1, 1, 1})});
  scene.lines.push_back({{{0, 0, 0}}, {1, 1, 1}, 2});
  CHECK((render(scene, isometric, {200, 150, false, 2}).rgba == before.rgba));
}
