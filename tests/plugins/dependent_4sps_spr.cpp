// The 4SPS-SPR's sixth pose coordinate follows from its revolute axis, whichever of them is chosen to.
#include <core/mechanics/model/state.hpp>
#include <tests/plugins/four_sps_spr.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr test::Dependent legal[] = {test::x, test::y, test::alpha, test::beta, test::gamma};

// All six pose coordinates of a pose.
std::array<double, 6> full_pose(const Machine& machine, const Pose& pose, const std::vector<double>& q, test::Dependent dependent) {
  std::array<double, 6> full{};
  std::size_t next = 0;
  for (std::size_t k = 0; k < 6; ++k) full[k] = static_cast<int>(k) == dependent ? pose.numbers[machine.layout().derived(0)] : q[next++];
  return full;
}

std::vector<double> random_coordinates(const Machine& machine, std::mt19937_64& random) {
  std::vector<double> q;
  for (const Coordinate& c : machine.topology().coordinates) q.push_back(std::uniform_real_distribution(c.box.min, c.box.max)(random));
  return q;
}

}  // namespace

TEST_CASE("a dependent coordinate keeps limb 5 perpendicular to the revolute axis") {
  for (const test::Dependent dependent : legal) {
    const Machine machine = test::make_four_sps_spr(dependent);
    const int a5 = test::joint_named(machine, "A5"), b5 = test::joint_named(machine, "B5"), platform = machine.topology().platform;
    const Vector3d axis_at_home = machine.axis(machine.home_pose(), b5);
    std::mt19937_64 random(71);
    int reached = 0;
    for (int k = 0; k < 500; ++k) {
      const std::vector<double> q = random_coordinates(machine, random);
      const Pose pose = machine.pose(q);
      if (pose.status != PM_OK) continue;
      ++reached;
      CAPTURE(test::pose_names[dependent], q);
      // The axis is carried from home by the platform, whose rotation is built here from the six coordinates.
      const std::array<double, 6> full = full_pose(machine, pose, q, dependent);
      const Eigen::Matrix3d r = (Eigen::AngleAxisd(full[3], Vector3d::UnitZ()) * Eigen::AngleAxisd(full[4], Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(full[5], Vector3d::UnitX()))
                                    .toRotationMatrix();
      CHECK((machine.rotation(pose, platform) - r).norm() < 1e-14);
      CHECK((machine.origin(pose, platform) - Vector3d(full[0], full[1], full[2])).norm() < 1e-14);
      CHECK(std::abs((r * axis_at_home).dot(machine.centre(pose, a5) - machine.centre(pose, b5))) < 1e-14);
    }
    CHECK(reached >= 400);
  }
}

TEST_CASE("home is the home pose whichever coordinate is dependent") {
  for (const test::Dependent dependent : legal) {
    CAPTURE(test::pose_names[dependent]);
    const Machine machine = test::make_four_sps_spr(dependent);
    const int platform = machine.topology().platform;
    CHECK((machine.origin(machine.home_pose(), platform) - Vector3d(0, 0, 0.55)).norm() < 1e-14);
    CHECK((machine.rotation(machine.home_pose(), platform) - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(machine.topology().derived.at(0).name == test::pose_names[dependent]);
    CHECK(machine.topology().derived.at(0).dependent);
    for (const Coordinate& c : machine.topology().coordinates) CHECK(c.name != test::pose_names[dependent]);
  }
}

TEST_CASE("the same pose comes out whichever coordinate is dependent") {
  const Machine by_y = test::make_four_sps_spr(test::y);
  std::mt19937_64 random(72);
  for (int k = 0; k < 200; ++k) {
    const std::vector<double> q = random_coordinates(by_y, random);
    const Pose pose = by_y.pose(q);
    REQUIRE(pose.status == PM_OK);
    const std::array<double, 6> full = full_pose(by_y, pose, q, test::y);
    for (const test::Dependent dependent : legal) {
      const Machine machine = test::make_four_sps_spr(dependent);
      CAPTURE(test::pose_names[dependent], full);
      const Pose same = machine.pose(test::independent(full, dependent));
      REQUIRE(same.status == PM_OK);
      CHECK(std::abs(same.numbers[machine.layout().derived(0)] - full[static_cast<std::size_t>(dependent)]) < 1e-12);
      for (std::size_t s = 1; s < machine.layout().derived(0); ++s) REQUIRE(std::abs(same.numbers[s] - pose.numbers[s]) < 1e-12);
    }
  }
}

TEST_CASE("z cannot be dependent: the default axis is horizontal") {
  try {
    test::make_four_sps_spr(test::z);
    FAIL("was accepted");
  } catch (const MechanismError& e) {
    CHECK(e.status == PM_BAD_ARGUMENT);
    CHECK(std::string(e.what()) == "z cannot be the dependent coordinate: it is not determined at home");
  }
}

TEST_CASE("a revolute axis that is not across limb 5 at home is refused with the direction of the limb") {
  try {
    const Machine machine(test::four_sps_spr(), test::values_with(test::four_sps_spr(), {{"revolute_axis", {1, 0, 0}}}));
    FAIL("was accepted");
  } catch (const MechanismError& e) {
    CHECK(e.status == PM_BAD_ARGUMENT);
    // A5 - p - B5 = (0.4 cos 315 deg - 0.1 cos 288 deg, 0.4 sin 315 deg - 0.1 sin 288 deg, -0.55).
    CHECK_THAT(e.what(), Catch::StartsWith("home cannot be assembled") && Catch::Contains("(0.251941, -0.187737, -0.55)"));
  }
}

TEST_CASE("strokes the wrong way round are refused") {
  CHECK_THROWS_WITH(Machine(test::four_sps_spr(), test::values_with(test::four_sps_spr(), {{"stroke_min", {0.9}}})),
                    "stroke_min must be less than stroke_max");
}

TEST_CASE("a pose that turns the revolute axis away from y is out of reach, and says why") {
  // n6 stands at an azimuth of 53.3 degrees at home: at alpha = -53.3 degrees it lies along x and y is free.
  const Machine machine = test::make_four_sps_spr(test::y);
  const double q[] = {0, 0.55, -53.3 * std::numbers::pi / 180, 0, 0};
  const Pose pose = machine.pose(q);
  CHECK(pose.status == PM_UNREACHABLE);
  CHECK(pose.why == "the revolute axis is almost perpendicular to the dependent coordinate, which it no longer determines");
  const Machine by_alpha = test::make_four_sps_spr(test::alpha);
  // With the axis tilted by a radian and the platform high above A5, the lever about Z is too short: 0.4 m against 0.5 * 5 m.
  const double far[] = {0, 0, 5, 1, 0};
  CHECK(by_alpha.pose(far).status == PM_UNREACHABLE);
  CHECK(by_alpha.pose(far).why == "no value of the dependent angle makes limb 5 perpendicular to the revolute axis");
}
