#include <core/mechanics/model/closure.hpp>

#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::AngleAxisd;
using Eigen::Vector3d;

namespace {

std::vector<BodyState> bodies_at(const Machine& machine, const std::vector<double>& q) {
  const Pose pose = machine.pose(q);
  REQUIRE(pose.status == PM_OK);
  return bodies_at_rest(machine, pose);
}

constexpr double closure_rounding = 1e-12;

}  // namespace

TEST_CASE("a mechanism that closes has no gap and no misalignment") {
  std::mt19937_64 random(41);
  for (const pm_mechanism* table : {&test::hexapod(), &test::four_bar(), &test::arm(), &test::slider_crank()}) {
    const Machine machine = test::make(*table);
    const Closure closure(machine);
    for (int k = 0; k < 50; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      const ClosureError e = closure.error(motion.state(machine).bodies);
      INFO(table->name << ", q = " << motion.q.transpose());
      CHECK(e.gap < closure_rounding);
      CHECK(e.misalignment < closure_rounding);  // by arc tangents: an arc cosine near zero would know half the digits
    }
  }
}

TEST_CASE("a body that is moved away is told by the joint that it leaves, and by how much") {
  const Machine machine = test::make(test::four_bar());
  const Closure closure(machine);
  std::vector<BodyState> bodies = bodies_at(machine, {1.2});
  bodies[3].origin.z() += 2e-3;  // the rocker, off both its pins by the same
  CHECK(closure.error(bodies).gap == Approx(2e-3).epsilon(1e-9));

  bodies = bodies_at(machine, {1.2});
  bodies[3].rotation = AngleAxisd(1e-6, Vector3d::UnitX()) * bodies[3].rotation;  // the rocker turns about its pin D, across the axis
  const ClosureError e = closure.error(bodies);
  CHECK(e.misalignment == Approx(1e-6).epsilon(1e-6));
  const auto& joints = machine.topology().joints;
  CHECK((joints[static_cast<std::size_t>(e.misalignment_joint)].name == "C" ||
         joints[static_cast<std::size_t>(e.misalignment_joint)].name == "D"));
  CHECK(joints[static_cast<std::size_t>(e.gap_joint)].name == "C");
}

TEST_CASE("a slide is no gap, but a shift across the slide is") {
  const Machine machine = test::make(test::arm());
  const Closure closure(machine);
  std::vector<BodyState> bodies = bodies_at(machine, {0.0, 0.3, 0.0});
  bodies[2].origin.x() += 0.1;
  CHECK(closure.error(bodies).gap < closure_rounding);
  bodies[2].origin.y() += 1e-4;
  CHECK(closure.error(bodies).gap == Approx(1e-4).epsilon(1e-9));
}

TEST_CASE("a prismatic joint keeps the orientation of what it carries, unless a leg may spin") {
  const Vector3d along = Vector3d::UnitZ();
  for (const test::BaseJoint base : {test::BaseJoint::ball, test::BaseJoint::universal}) {
    const Machine machine = test::make_hexapod(base);
    const Closure closure(machine);
    const Eigen::VectorXd home = machine.home();
    std::vector<BodyState> bodies = bodies_at(machine, {home.data(), home.data() + 6});
    BodyState& piston = bodies[static_cast<std::size_t>(test::body_named(machine, "piston 3"))];
    piston.rotation = piston.rotation * AngleAxisd(0.2, along);
    const ClosureError e = closure.error(bodies);
    if (base == test::BaseJoint::ball) {
      CHECK(e.misalignment < closure_rounding);
    } else {
      CHECK(e.misalignment == Approx(0.2).epsilon(1e-9));
      CHECK(machine.topology().joints[static_cast<std::size_t>(e.misalignment_joint)].name == "P3");
    }
  }
}

TEST_CASE("motions of revolute and cylindrical joints count from home, positive as b turns about the axis relative to a") {
  const Machine machine = test::make(test::arm());
  const Closure closure(machine);
  const Eigen::VectorXd home = machine.home();
  const std::vector<BodyState> bodies = bodies_at(machine, {home(0) + 0.25, 0.3, -0.4});
  REQUIRE(closure.motion(bodies, 0).size() == 1);
  CHECK(closure.motion(bodies, 0)[0] == Approx(0.25).epsilon(1e-12));
  CHECK(closure.motion(bodies, 1)[0] == Approx(-0.4).epsilon(1e-12));
}

TEST_CASE("in a four-bar, the angles at the four pins close to nothing") {
  // Around the loop the rotations add up: A + B + C = D, each from home.
  const Machine machine = test::make(test::four_bar());
  const Closure closure(machine);
  for (const double theta : {0.5, 0.8, 1.3, 1.5}) {
    CAPTURE(theta);
    const std::vector<BodyState> bodies = bodies_at(machine, {theta});
    CHECK(closure.motion(bodies, 0)[0] == Approx(theta - 1.0).margin(1e-12));
    CHECK(closure.motion(bodies, 0)[0] + closure.motion(bodies, 1)[0] + closure.motion(bodies, 2)[0] ==
          Approx(closure.motion(bodies, 3)[0]).margin(1e-12));
  }
}

TEST_CASE("a prismatic joint's motion is its travel from home, a ball's the deflection of its stud") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  const Closure closure(machine);
  const Pose home = machine.home_pose(), moved = machine.pose(std::vector<double>{0.05, -0.03, 0.66, 0.1, -0.05, 0.12});
  const std::vector<BodyState> bodies = bodies_at_rest(machine, moved);
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    const int a = 3 * i, p = 3 * i + 1, b = 3 * i + 2;
    const auto limb = [&](const Pose& pose) -> Vector3d { return machine.centre(pose, b) - machine.centre(pose, a); };
    CHECK(closure.motion(bodies, p)[0] == Approx(limb(moved).norm() - limb(home).norm()).margin(1e-12));
    const Vector3d before = limb(home).normalized(), now = limb(moved).normalized();
    CHECK(closure.motion(bodies, a)[0] == Approx(std::acos(before.dot(now))).epsilon(1e-9));
    const Vector3d carried = machine.rotation(moved, machine.topology().platform) * before;
    CHECK(closure.motion(bodies, b)[0] == Approx(std::acos(carried.dot(now))).epsilon(1e-9));
  }
}

TEST_CASE("a universal joint's two angles rebuild the orientation of its leg") {
  // From home: the leg turns by the first angle about the axis held by the base, then by the second about its own.
  const Machine machine = test::make_hexapod(test::BaseJoint::universal);
  const Closure closure(machine);
  std::mt19937_64 random(42);
  for (int k = 0; k < 20; ++k) {
    const test::Motion motion = test::random_motion(machine, random);
    CAPTURE(motion.q.transpose());
    const Pose pose = machine.pose({motion.q.data(), 6});
    const std::vector<BodyState> bodies = bodies_at_rest(machine, pose);
    for (int i = 0; i < 6; ++i) {
      const int joint = 3 * i, leg = 2 + 2 * i;
      const std::vector<double> angles = closure.motion(bodies, joint);
      REQUIRE(angles.size() == 2);
      const Vector3d first = machine.axis(machine.home_pose(), joint, 0), second = machine.axis(machine.home_pose(), joint, 1);
      const Eigen::Matrix3d rebuilt =
          AngleAxisd(angles[0], first) * AngleAxisd(angles[1], second) * machine.rotation(machine.home_pose(), leg);
      CHECK((rebuilt - machine.rotation(pose, leg)).norm() < closure_rounding);
    }
  }
}
