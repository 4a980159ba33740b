// Displacement of the Delta robot against a construction that knows only distances: with the arms given, the platform lies where three
// spheres meet.
#include <core/mechanics/displacement/displacement.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/delta.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr double rounding_of_delta = 1e-10;  // [m], [rad]; of lengths near 1 m, with room for the square roots of the construction

// Every rod keeps its length while the platform keeps its orientation, so p lies on a sphere of the rods' length about each elbow, moved
// inwards by the platform's radius.
Vector3d centre_of_sphere(const test::DeltaSizes& s, int limb, double theta) {
  const double out = s.base + s.arm * std::cos(theta) - s.platform, azimuth = test::delta_azimuths[limb];
  return {out * std::cos(azimuth), out * std::sin(azimuth), -s.arm * std::sin(theta)};
}

// The two points at distance r from three points a, b, c: over the centre of their circle, at height sqrt(r^2 - R^2) to either side of
// their plane. Circumcentre by barycentric weights, sin 2A : sin 2B : sin 2C.
struct Meeting {
  bool real;
  Vector3d low, high;
};
Meeting three_spheres(const Vector3d& a, const Vector3d& b, const Vector3d& c, double r) {
  const double aa = (b - c).squaredNorm(), bb = (c - a).squaredNorm(), cc = (a - b).squaredNorm();
  const Vector3d weight(aa * (bb + cc - aa), bb * (cc + aa - bb), cc * (aa + bb - cc));
  const Vector3d centre = (weight(0) * a + weight(1) * b + weight(2) * c) / weight.sum();
  const double height2 = r * r - (a - centre).squaredNorm();
  Vector3d up = (b - a).cross(c - a).normalized();
  if (up.z() < 0) up = -up;
  const Vector3d rise = std::sqrt(std::max(height2, 0.0)) * up;
  return {height2 > 0, centre - rise, centre + rise};
}

Pose pose_at(const Machine& machine, const Vector3d& p) { return machine.pose({p.data(), 3}); }
double theta_of(const Machine& machine, const Pose& pose, int limb) { return pose.numbers[machine.layout().actuator(limb)]; }
double turned(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

}  // namespace

TEST_CASE("the arms of the Delta stand as the spheres about their elbows demand") {
  const test::DeltaSizes all[] = {{}, {0.15, 0.05, 0.3, 0.8}, {0.1, 0.18, 0.4, 0.9}};
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> angle(-40 * deg, 60 * deg);
  for (const test::DeltaSizes& s : all) {
    const Machine machine(test::delta(), test::delta_values(s));
    int met = 0;
    for (int k = 0; k < 300; ++k) {
      const Vector3d theta(angle(random), angle(random), angle(random));
      const Meeting m =
          three_spheres(centre_of_sphere(s, 0, theta(0)), centre_of_sphere(s, 1, theta(1)), centre_of_sphere(s, 2, theta(2)), s.rod);
      if (!m.real) continue;
      ++met;
      const Pose pose = pose_at(machine, m.low);
      CAPTURE(theta.transpose() / deg, m.low.transpose());
      REQUIRE(pose.status == PM_OK);
      for (int i = 0; i < 3; ++i) CHECK(std::abs(theta_of(machine, pose, i) - theta(i)) < rounding_of_delta);
    }
    CHECK(met > 250);
  }
}

TEST_CASE("forward displacement of the Delta finds the platform where the spheres meet") {
  const test::DeltaSizes s;
  const Machine machine(test::delta(), test::delta_values(s));
  ForwardSolver forward(machine);
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> angle(-30 * deg, 40 * deg);
  for (int k = 0; k < 100; ++k) {
    const Eigen::VectorXd theta = Vector3d(angle(random), angle(random), angle(random));
    const Meeting m =
        three_spheres(centre_of_sphere(s, 0, theta(0)), centre_of_sphere(s, 1, theta(1)), centre_of_sphere(s, 2, theta(2)), s.rod);
    REQUIRE(m.real);
    const ForwardSolution found = forward.solve(theta, machine.home());
    CAPTURE(theta.transpose() / deg, found.why);
    REQUIRE(found.outcome == Outcome::good);
    CHECK((found.coordinates - m.low).norm() < rounding_of_delta);
  }
}

TEST_CASE("with the elbows in, the other solution of the Delta's inverse displacement is as good") {
  const test::DeltaSizes s;
  const Machine out(test::delta(), test::delta_values(s)), in(test::delta(), test::delta_values(s, test::all_elbows(1)));
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> side(-0.25, 0.25), depth(-1.2, -0.9);
  for (int k = 0; k < 100; ++k) {
    const Vector3d p(side(random), side(random), depth(random));
    const Pose one = pose_at(out, p), other = pose_at(in, p);
    REQUIRE(one.status == PM_OK);
    REQUIRE(other.status == PM_OK);
    for (int i = 0; i < 3; ++i) {
      CAPTURE(p.transpose(), i);
      for (const auto& [machine, pose] : {std::pair{&out, &one}, std::pair{&in, &other}})
        CHECK(std::abs((p - centre_of_sphere(s, i, theta_of(*machine, *pose, i))).norm() - s.rod) < rounding_of_delta);
      CHECK(theta_of(in, other, i) > theta_of(out, one, i) + 10 * deg);  // the arm hangs lower
    }
  }
}

TEST_CASE("each elbow of the Delta is chosen for itself") {
  const test::DeltaSizes s;
  const Machine out(test::delta(), test::delta_values(s)), in(test::delta(), test::delta_values(s, test::all_elbows(1)));
  const Machine second(test::delta(), test::delta_values(s, {{"elbow2", {1}}}));
  const Vector3d p(0.1, -0.05, -1.1);
  for (int i = 0; i < 3; ++i)
    CHECK(theta_of(second, pose_at(second, p), i) == theta_of(i == 1 ? in : out, pose_at(i == 1 ? in : out, p), i));
}

TEST_CASE("arm angles of the FlexPicker that Williams prints come out to the last digit printed") {
  // Sides of the base's and the platform's triangle 567 and 76 mm: motors at the middle of the sides, rods at the corners.
  const test::DeltaSizes s{std::sqrt(3.0) / 6 * 0.567, std::sqrt(3.0) / 3 * 0.076, 0.524, 1.244};
  const Machine machine(test::delta(), test::delta_values(s));
  struct Printed {
    Vector3d p, theta;  // [m], [deg]
  };
  const Printed all[] = {{{0, 0, -0.9}, {-20.5, -20.5, -20.5}}, {{0.3, 0.5, -1.1}, {47.5, -11.6, 21.4}}};
  constexpr double half_digit = 0.05;  // [deg]
  for (const Printed& printed : all) {
    const Pose pose = pose_at(machine, printed.p);
    REQUIRE(pose.status == PM_OK);
    for (int i = 0; i < 3; ++i) CHECK(std::abs(theta_of(machine, pose, i) / deg - printed.theta(i)) < half_digit);
  }
}

TEST_CASE("the Delta reaches as far as a stretched limb, and no farther") {
  const test::DeltaSizes s;
  const Machine machine(test::delta(), test::delta_values(s));
  // Straight down all three limbs stretch at once, each from A to C over L + l.
  const double across = s.base - s.platform, reach = s.arm + s.rod, lowest = -std::sqrt(reach * reach - across * across);
  CHECK(pose_at(machine, {0, 0, lowest + 1e-9}).status == PM_OK);
  const Pose beyond = pose_at(machine, {0, 0, lowest - 1e-9});
  CHECK(beyond.status == PM_UNREACHABLE);
  CHECK(beyond.why == "a platform joint is too far from its motor, or too near, for arm and rods");
  // Folded, a rod cannot come nearer to the motor than l - L.
  CHECK(pose_at(machine, {0, 0, -std::sqrt(std::pow(s.rod - s.arm, 2) - across * across) + 1e-9}).status == PM_UNREACHABLE);

  // Where it is stretched an arm stands in the rods' direction, from both sides of the fold. The angle opens like a square root.
  const Machine in(test::delta(), test::delta_values(s, test::all_elbows(1)));
  const Vector3d near(0, 0, lowest + 1e-10);
  const double direction = std::atan2(-lowest, -across);
  for (int i = 0; i < 3; ++i) {
    CHECK(std::abs(turned(theta_of(machine, pose_at(machine, near), i) - direction)) < 1e-4);
    CHECK(std::abs(turned(theta_of(in, pose_at(in, near), i) - direction)) < 1e-4);
  }
}

TEST_CASE("an angle of the Delta's arms does not jump where an arm points inwards or down") {
  const test::DeltaSizes s;
  const Machine machine(test::delta(), test::delta_values(s, test::all_elbows(1)));
  double before = 0;
  bool level = false;  // an arm passed through pointing inwards
  for (int k = 0; k <= 400; ++k) {
    const Pose pose = pose_at(machine, {0, 0, -0.8 - 0.001 * k});
    REQUIRE(pose.status == PM_OK);
    const double theta = theta_of(machine, pose, 0);
    if (k > 0) CHECK(std::abs(theta - before) < 2 * deg);
    if (k > 0 && (theta < 180 * deg) != (before < 180 * deg)) level = true;
    before = theta;
  }
  CHECK(level);
}

TEST_CASE("sizes from which the Delta cannot be assembled are refused with what to change") {
  const auto refusal = [](const test::DeltaSizes& s, std::map<std::string, std::vector<double>> more = {}) -> std::string {
    try {
      const Machine machine(test::delta(), test::delta_values(s, std::move(more)));
    } catch (const MechanismError& e) {
      CHECK(e.status == PM_BAD_ARGUMENT);
      return e.what();
    }
    return "";
  };
  CHECK(refusal({}) == "");
  CHECK(refusal({0.2, 0.08, 0.524, 0.644}) ==
        "home has level arms, from whose elbows the rods must hang: rod_length must be above 0.657143 m");
  CHECK(refusal({}, {{"arm_highest", {1.0}}, {"arm_lowest", {0.5}}}) == "arm_highest must be less than arm_lowest: theta lowers the arm");
}
