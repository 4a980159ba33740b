#include <reports/section/workspace/surface.hpp>

#include <Eigen/Geometry>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <set>

using namespace pmreport;
using namespace pmreport::section;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

std::vector<scan::Axis> cube(double from, double to, std::size_t count) {
  return {{0, from, to, count}, {1, from, to, count}, {2, from, to, count}};
}

std::vector<double> sampled(const std::vector<scan::Axis>& axes, const std::function<double(const Vector3d&)>& f) {
  std::vector<double> out;
  for (std::size_t i = 0; i < axes[0].count; ++i)
    for (std::size_t j = 0; j < axes[1].count; ++j)
      for (std::size_t k = 0; k < axes[2].count; ++k) out.push_back(f({axes[0].value(i), axes[1].value(j), axes[2].value(k)}));
  return out;
}

// Every edge is walked once in each direction; what is left over is a hole, or more than two triangles at an edge.
bool closed(const scene::Surface& s) {
  std::map<std::pair<int, int>, int> walked;
  for (const auto& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++walked[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, times] : walked)
    if (times != 1 || !walked.contains({edge.second, edge.first})) return false;
  return true;
}

int euler(const scene::Surface& s) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  return static_cast<int>(s.points.size()) - static_cast<int>(edges.size()) + static_cast<int>(s.triangles.size());
}

double ball(const Vector3d& p) { return 0.8 - p.norm(); }

}  // namespace

TEST_CASE("the surface of a ball is closed, a sphere, and encloses its volume, the better the finer the grid") {
  const double exact = 4 * pi / 3 * std::pow(0.8, 3);
  double before = 1;
  for (const std::size_t count : {11, 21, 41}) {
    CAPTURE(count);
    const auto axes = cube(-1, 1, count);
    const scene::Surface s = boundary_surface(axes, sampled(axes, ball));
    CHECK(closed(s));
    CHECK(euler(s) == 2);
    const double off = std::abs(enclosed_volume(s) / exact - 1);
    CHECK(off < before / 3);  // of second order in the step: a quarter each time, less what the first terms do not tell
    before = off;
    // An edge of a tetrahedron is at most sqrt(3) steps long, the second derivative of the distance there at most 1 / 0.7; and the surface
    // keeps a thousandth of an edge from its ends.
    const double edge = std::sqrt(3.0) * axes[0].step();
    for (const Vector3d& p : s.points) CHECK(std::abs(ball(p)) < edge * edge / 8 / 0.7 + 1e-3 * edge);
  }
  CHECK(before < 0.003);
}

TEST_CASE("a shell has two spheres, and what is within the inner one does not count") {
  const auto axes = cube(-1, 1, 41);
  const scene::Surface s =
      boundary_surface(axes, sampled(axes, [](const Vector3d& p) { return std::min(0.8 - p.norm(), p.norm() - 0.4); }));
  CHECK(closed(s));
  CHECK(euler(s) == 4);
  CHECK(enclosed_volume(s) == Approx(4 * pi / 3 * (0.512 - 0.064)).epsilon(0.005));
}

TEST_CASE("what goes on beyond the grid ends at its rim") {
  SECTION("all of it") {
    const std::vector<scan::Axis> axes{{0, -1, 2, 5}, {1, 0, 1, 3}, {2, 5, 5.5, 2}};
    const scene::Surface s = boundary_surface(axes, std::vector<double>(30, 1.0));
    CHECK(closed(s));
    CHECK(euler(s) == 2);
    CHECK(enclosed_volume(s) == Approx(1.5));
  }
  SECTION("half a ball, and a quarter of it, with an edge on the rim") {
    for (const auto& [low_y, share] : {std::pair{-1.0, 2.0}, {0.0, 4.0}}) {
      const std::vector<scan::Axis> axes{{0, 0, 1, 31}, {1, low_y, 1, low_y < 0 ? 61u : 31u}, {2, -1, 1, 61}};
      const scene::Surface s = boundary_surface(axes, sampled(axes, ball));
      CHECK(closed(s));
      CHECK(euler(s) == 2);
      CHECK(enclosed_volume(s) == Approx(4 * pi / 3 * 0.512 / share).epsilon(0.003));
    }
  }
}

TEST_CASE("axes that run downward turn nothing inside out") {
  auto axes = cube(-1, 1, 21);
  for (std::size_t k = 0; k < 3; ++k) {
    std::swap(axes[k].from, axes[k].to);
    CAPTURE(k);
    const scene::Surface s =
        boundary_surface(axes, sampled(axes, [](const Vector3d& p) { return 0.3 - (p - Vector3d(0.4, 0.3, -0.2)).norm(); }));
    CHECK(closed(s));
    CHECK(enclosed_volume(s) == Approx(4 * pi / 3 * 0.027).epsilon(0.08));  // three steps a radius
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& p : s.points) middle += p / static_cast<double>(s.points.size());
    CHECK((middle - Vector3d(0.4, 0.3, -0.2)).norm() < 0.02);
  }
}

TEST_CASE("any values at all give a closed surface, zeros and missing ones among them") {
  std::mt19937_64 random(7);
  std::uniform_int_distribution<int> pick(-2, 2), missing(0, 9);
  const std::vector<scan::Axis> axes{{0, 0, 1, 6}, {1, 0, 2, 7}, {2, 3, 4, 5}};
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    std::vector<double> values;
    for (int k = 0; k < 6 * 7 * 5; ++k) values.push_back(missing(random) == 0 ? std::nan("") : pick(random));
    const scene::Surface s = boundary_surface(axes, values);
    CHECK(closed(s));
    std::set<std::array<float, 3>> places;  // as STL keeps them
    for (const Vector3d& p : s.points) {
      CHECK(p.allFinite());
      places.insert({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
    }
    CHECK(places.size() == s.points.size());
  }
}

TEST_CASE("no point inside is no surface: grids that have none are refused") {
  const auto axes = cube(0, 1, 3);
  CHECK(boundary_surface(axes, std::vector<double>(27, -1.0)).triangles.empty());
  CHECK(enclosed_volume({}) == 0);
  CHECK_THROWS_AS(boundary_surface({axes[0], axes[1]}, std::vector<double>(9, 1.0)), std::invalid_argument);
  CHECK_THROWS_AS(boundary_surface({axes[0], axes[1], {2, 0, 1, 1}}, std::vector<double>(9, 1.0)), std::invalid_argument);
  CHECK_THROWS_AS(boundary_surface(axes, std::vector<double>(26, 1.0)), std::invalid_argument);
}
