#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/random_poses.hpp>

#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <set>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

PlatformFreedoms freedoms_of_platform(const Machine& machine, const State& state) {
  return platform_freedoms(machine, state, generic_model(machine, state));
}

// Where lines AB and DC of a four-bar meet: the coupler turns about this point.
Vector3d instant_centre(const State& s) {
  const Vector3d a = s.joints[0].centre, b = s.joints[1].centre, c = s.joints[2].centre, d = s.joints[3].centre;
  const Vector3d u = b - a, w = c - d;
  return a + u * ((d - a).cross(w).z() / u.cross(w).z());
}

}  // namespace

TEST_CASE("a four-bar's coupler turns about the point where crank and rocker meet, and nothing else") {
  const Machine machine = test::make(test::four_bar());
  std::mt19937_64 random(41);
  for (int k = 0; k < 10; ++k) {
    const State s = state_at_rest(machine, test::random_motion(machine, random).q);
    const PlatformFreedoms f = freedoms_of_platform(machine, s);
    REQUIRE(f.freedoms() == 1);
    CHECK(f.translations.cols() == 0);
    REQUIRE(f.rotations.cols() == 1);
    const Screw turn = screw_of_twist(f.twists.basis.col(0), f.twists.origin, 0.3);
    CHECK(turn.is_line());
    CHECK(turn.parallel(Vector3d::UnitZ()));
    CHECK(turn.distance(instant_centre(s)) < 1e-9 * (1 + instant_centre(s).norm()));
    CHECK(f.constraints.dimension() == 5);
  }
}

TEST_CASE("a platform on six limbs moves in every way, and no limb holds it against anything") {
  for (const test::BaseJoint base : {test::BaseJoint::ball, test::BaseJoint::universal}) {
    const Machine machine = test::make_hexapod(base);
    const State s = state_at_rest(machine, machine.home());
    const GenericModel model = generic_model(machine, s);
    const PlatformFreedoms f = platform_freedoms(machine, s, model);
    CHECK(f.freedoms() == 6);
    CHECK(f.translations.isIdentity(1e-9));
    CHECK(f.rotations.isIdentity(1e-9));
    const std::vector<LimbSystem> limbs = limb_systems(machine, s, model);
    REQUIRE(limbs.size() == 6);
    for (const LimbSystem& l : limbs) {
      CHECK(l.alone);
      CHECK(l.joints.size() == 3);
      CHECK(l.twists.dimension() == 6);
      CHECK(l.constraints.dimension() == 0);
    }
  }
}

TEST_CASE("an arm of two joints lets its end turn, slide and roll: one translation and two rotations") {
  const Machine machine = test::make(test::arm());
  const double theta = 0.4;
  const State s = state_at_rest(machine, Vector3d(theta, 0.3, 0.2));
  const PlatformFreedoms f = freedoms_of_platform(machine, s);
  CHECK(f.freedoms() == 3);
  const Vector3d along(std::cos(theta), std::sin(theta), 0);
  REQUIRE(f.translations.cols() == 1);
  CHECK((f.translations.col(0) - along).norm() < 1e-9);
  REQUIRE(f.rotations.cols() == 2);  // about Z and about the arm
  CHECK((f.rotations.col(0) - Vector3d::UnitZ()).norm() < 1e-9);
  CHECK((f.rotations.col(1) - along).norm() < 1e-9);
}

TEST_CASE("the three constraints too many of a planar four-bar are a force and two couples that go round its loop") {
  const Machine machine = test::make(test::four_bar());
  std::mt19937_64 random(42);
  const State s = state_at_rest(machine, test::random_motion(machine, random).q);
  const std::vector<SelfStress> stresses = self_stresses(machine, s, generic_model(machine, s));
  REQUIRE(stresses.size() == 3);
  int couples = 0;
  for (const SelfStress& stress : stresses) {
    CHECK(stress.shares.size() == 4);
    CHECK(stress.same);
    const Screw& w = stress.at_first.screw;
    if (w.is_free()) {
      ++couples;
      CHECK(std::abs(w.direction.z()) < 1e-9);
    } else {
      CHECK(w.is_line());
      CHECK(w.parallel(Vector3d::UnitZ()));
    }
    // Every body is in equilibrium: what comes in at one of its joints goes out at the other.
    for (std::size_t body = 1; body < machine.topology().bodies.size(); ++body) {
      Vector6d sum = Vector6d::Zero();
      for (const SelfStress::Share& share : stress.shares) {
        const Joint& j = machine.topology().joints[static_cast<std::size_t>(share.joint)];
        if (j.b == static_cast<int>(body)) sum += share.wrench;
        if (j.a == static_cast<int>(body)) sum -= share.wrench;
      }
      CHECK(sum.norm() < 1e-9);
    }
  }
  CHECK(couples == 2);
}

TEST_CASE("a mechanism without redundant constraints has no self-stress") {
  const Machine machine = test::make_hexapod(test::BaseJoint::universal);
  const State s = state_at_rest(machine, machine.home());
  CHECK(self_stresses(machine, s, generic_model(machine, s)).empty());
}

TEST_CASE("random poses lie in the box, can be assembled, and come again with the same seed") {
  const Machine machine = test::make(test::four_bar());
  const auto first = random_poses(machine, 50, 3), again = random_poses(machine, 50, 3), other = random_poses(machine, 50, 4);
  REQUIRE(first.size() == 50);
  std::set<double> different;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const Range box = machine.topology().coordinates[0].box;
    CHECK(first[k](0) >= box.min);
    CHECK(first[k](0) <= box.max);
    CHECK(machine.pose({first[k].data(), 1}).status == PM_OK);
    different.insert(first[k](0));
  }
  CHECK(different.size() == 50);
  CHECK(first == again);
  CHECK(first != other);
}
