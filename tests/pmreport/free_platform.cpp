// A platform with six freedoms: its angles, and what their rates make of it, against Eigen's own rotations.
#include <catch2/catch.hpp>
#include <pmreport/free_platform.hpp>
#include <pmreport/mechanism.hpp>

#include <array>
#include <random>

using namespace pmreport;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

using Pose = std::array<double, 6>;

Matrix3<double> rotation(const Pose& q) {
  return (AngleAxisd(q[3], Vector3d::UnitZ()) * AngleAxisd(q[4], Vector3d::UnitX()) * AngleAxisd(q[5], Vector3d::UnitY()))
      .toRotationMatrix();
}
Vector3d point(const Pose& q, const Vector3d& b) { return Vector3d(q[0], q[1], q[2]) + rotation(q) * b; }

Pose random_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> within(-1, 1);
  Pose q;
  for (double& x : q) x = within(random);
  return q;
}

}  // namespace

TEST_CASE("a free platform stands at x, y, z and is turned about z, then x, then y") {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  const Layout layout(t);
  std::vector<double> numbers(layout.size());
  Placement<double> at(numbers.data(), 1, layout);
  std::mt19937_64 random(20240501);
  for (int k = 0; k < 20; ++k) {
    const Pose q = random_pose(random);
    const Matrix3<double> r = place_free(at, t.platform, q);
    CHECK((r - rotation(q)).norm() < 1e-15 * 4);
    CHECK(at.rotation(t.platform) == r);
    CHECK(at.origin(t.platform) == Vector3d(q[0], q[1], q[2]));
  }
}

TEST_CASE("rates of the pose give the twist, and the motion of every point") {
  // Central differences of a step h err by h^2 / 6 of third derivatives, all below 10 here, and by roundings, 1e-16 / h.
  constexpr double h = 1e-5, tolerance = 1e-9;
  std::mt19937_64 random(20240502);
  for (int n = 0; n < 20; ++n) {
    const Pose q = random_pose(random);
    const Vector3d b(0.3, -0.2, 0.5);
    const Matrix3<double> r = rotation(q);
    const Matrix6<double> d = twist_map(q, r);
    const auto partials = point_partials(d, r * b);
    for (std::size_t k = 0; k < 6; ++k) {
      CAPTURE(n, k);
      Pose after = q, before = q;
      after[k] += h, before[k] -= h;
      const Vector3d moved = (point(after, b) - point(before, b)) / (2 * h);
      CHECK((partials.col(int(k)) - moved).norm() < tolerance);
      const Matrix3<double> turning = (rotation(after) - rotation(before)) / (2 * h) * r.transpose();  // skew: w x
      CHECK((d.col(int(k)).tail<3>() - Vector3d(turning(2, 1), turning(0, 2), turning(1, 0))).norm() < tolerance);
      CHECK((d.col(int(k)).head<3>() - (k < 3 ? Vector3d(Vector3d::Unit(int(k))) : Vector3d(0, 0, 0))).norm() == 0);
    }
  }
}

TEST_CASE("coordinates of a free platform stand about home, lengths and angles each in a box of their own") {
  const auto c = free_pose({1, 2, 3, 0.1, 0.2, 0.3}, 0.5, 0.25);
  REQUIRE(c.size() == 6);
  CHECK(c[2].name == "z");
  CHECK(c[2].unit == "m");
  CHECK(c[2].home == 3);
  CHECK(c[2].box.min == 2.5);
  CHECK(c[2].box.max == 3.5);
  CHECK(c[4].name == "beta");
  CHECK(c[4].title == "turn about x1");
  CHECK(c[4].unit == "rad");
  CHECK(c[4].box.max == 0.45);
}
