#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <random>
#include <reports/scene/scene.hpp>

using namespace pmreport::scene;
using Eigen::Vector3d;
using pmreport::deg;

namespace {

constexpr double rounding = 1e-9;  // [px] of numbers below 1e4 after a dozen operations

// The camera as a turn of the world: about z by -azimuth, then about x by elevation, so that the line of sight becomes +Y, up stays Z.
Eigen::Vector2d turned_and_dropped(const Camera& c, const Vector3d& p, int width, int height) {
  const Eigen::Matrix3d turn =
      (Eigen::AngleAxisd(c.elevation, Vector3d::UnitX()) * Eigen::AngleAxisd(-c.azimuth, Vector3d::UnitZ())).matrix();
  const Vector3d q = turn * (p - c.target) * (height / c.height);
  return {width * 0.5 + q.x(), height * 0.5 - q.z()};
}

}  // namespace

TEST_CASE("a point appears where turning the world before a fixed viewer puts it") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const Camera c{{unit(random), unit(random), unit(random)}, 3 * unit(random), 1.5 * unit(random), 1.2 + unit(random)};
    const Vector3d p(unit(random), unit(random), unit(random));
    CHECK((project(c, p, 800, 600) - turned_and_dropped(c, p, 800, 600)).norm() < rounding);
  }
}

TEST_CASE("the front view looks along +Y, the side view along -X, the top view down") {
  const Camera front{{0, 0, 0}, 0, 0, 2}, side{{0, 0, 0}, 90 * deg, 0, 2}, top{{0, 0, 0}, 0, 90 * deg, 2};
  const auto at = [](const Camera& c, double x, double y, double z) { return project(c, {x, y, z}, 200, 200); };
  CHECK((at(front, 0.5, 0.3, 0.2) - Eigen::Vector2d(150, 80)).norm() < rounding);
  CHECK((at(side, 0.3, 0.5, 0.2) - Eigen::Vector2d(150, 80)).norm() < rounding);
  CHECK((at(top, 0.5, 0.2, 0.3) - Eigen::Vector2d(150, 80)).norm() < rounding);
}

TEST_CASE("a frame holds all that was included, in every direction, and wastes little") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    Bounds bounds;
    std::vector<std::pair<Vector3d, double>> balls;
    for (int i = 0; i < 30; ++i) balls.emplace_back(Vector3d(unit(random), unit(random), 0.5 * unit(random)), 0.05 + 0.05 * unit(random));
    for (const auto& [p, r] : balls) bounds.include(p, r);
    const double azimuth = 3 * unit(random), elevation = 1.5 * unit(random);
    const Camera c = frame(bounds, azimuth, elevation, 4.0 / 3);
    const double scale = 600 / c.height;
    double left = 800, right = 0, top = 600, bottom = 0;
    for (const auto& [p, r] : balls) {
      const Eigen::Vector2d q = project(c, p, 800, 600);
      left = std::min(left, q.x() - r * scale), right = std::max(right, q.x() + r * scale);
      top = std::min(top, q.y() - r * scale), bottom = std::max(bottom, q.y() + r * scale);
    }
    // The margin is 7 % of a side; between the directions that bounds remember, 1.5 % may go unseen.
    const double least = 0.055;
    CHECK(std::min(left, 800 - right) >= least * 800 - 1);
    CHECK(std::min(top, 600 - bottom) >= least * 600 - 1);
    CHECK(((right - left) / 800 > 0.82 || (bottom - top) / 600 > 0.82));
  }
}

TEST_CASE("bounds without a point frame a metre") { CHECK(frame({}, 0.3, 0.4, 1.5).height == 1); }
