// What the limbs of the 2Q-SPR let the platform do: its mobility, its dependent coordinate, its working modes.
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/two_q_spr.hpp>

#include <catch2/catch.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

Machine make_two_q_spr(const std::map<std::string, std::vector<double>>& changes = {}) {
  return Machine(test::two_q_spr(), test::values_with(test::two_q_spr(), changes));
}

VectorXd random_pose(const Machine& machine, std::mt19937_64& random) {
  VectorXd q(machine.dof());
  for (int i = 0; i < q.size(); ++i) {
    const Range& box = machine.topology().coordinates[static_cast<std::size_t>(i)].box;
    q(i) = std::uniform_real_distribution(box.min, box.max)(random);
  }
  return q;
}

Pose reachable(const Machine& machine, const VectorXd& q) {
  const Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(pose.status == PM_OK);
  return pose;
}

std::string refusal(const std::map<std::string, std::vector<double>>& changes) {
  try {
    make_two_q_spr(changes);
  } catch (const MechanismError& e) {
    CHECK(e.status == PM_BAD_ARGUMENT);
    return e.what();
  }
  return "was accepted";
}

}  // namespace

TEST_CASE("eighteen links and twenty-one joints leave five freedoms, because six constraints are redundant") {
  for (const double rods_1 : {0.0, 1.0})
    for (const double rods_2 : {0.0, 1.0}) {
      const Machine machine = make_two_q_spr({{"rods_1", {rods_1}}, {"rods_2", {rods_2}}});
      std::mt19937_64 random(91);
      for (int k = 0; k < 10; ++k) {
        const VectorXd q = k == 0 ? machine.home() : random_pose(machine, random), zero = VectorXd::Zero(5);
        CAPTURE(rods_1, rods_2, q.transpose());
        State s;
        evaluate(machine, q.data(), zero.data(), zero.data(), s);
        REQUIRE(s.status == PM_OK);
        const Mobility m = mobility(machine, s);
        CHECK(m.bodies == 18);
        CHECK(m.joints == 21);
        CHECK(m.freedoms_sum == 23);
        CHECK(m.gruebler == -1);  // 6 (18 - 21 - 1) + 23; each planar loop repeats three of its constraints
        CHECK(m.rows == 103);
        CHECK(m.rank == 97);
        CHECK(m.redundant == 6);
        CHECK(m.freedoms == 5);
        CHECK(m.idle == 0);
      }
    }
}

TEST_CASE("y keeps the SPR limb perpendicular to its hinge, wherever the hinge points") {
  // Perpendicular to the limb at home, b3 - B3 = (sqrt(3), 1, 0) 0.12 m / (2 sqrt(3)) + (0, 0, 0.3 m), as three axes in the platform.
  const Vector3d limb(0.06, 0.06 / std::sqrt(3.0), 0.3);
  const Vector3d axes[] = {
      {0.5, -std::sqrt(0.75), 0}, limb.cross(Vector3d::UnitX()).normalized(), limb.cross(Vector3d(1, 0, 1)).normalized()};
  for (const Vector3d& axis : axes) {
    const Machine machine = make_two_q_spr({{"revolute_axis", {axis.x(), axis.y(), axis.z()}}});
    const int s3 = test::joint_named(machine, "S3"), r3 = test::joint_named(machine, "R3"), platform = machine.topology().platform;
    std::mt19937_64 random(92);
    for (int k = 0; k < 200; ++k) {
      const VectorXd q = random_pose(machine, random);
      CAPTURE(axis.transpose(), q.transpose());
      const Pose pose = reachable(machine, q);
      const Eigen::Matrix3d r = (Eigen::AngleAxisd(q(2), Vector3d::UnitZ()) * Eigen::AngleAxisd(q(3), Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(q(4), Vector3d::UnitX()))
                                    .toRotationMatrix();
      const Vector3d p(q(0), pose.numbers[machine.layout().derived(0)], q(1));
      CHECK((machine.rotation(pose, platform) - r).norm() < 1e-14);
      CHECK((machine.origin(pose, platform) - p).norm() < 1e-14);
      const Vector3d b3 = p + r * Vector3d(-0.06, -0.06 / std::sqrt(3.0), 0), b3_from_base = b3 - machine.centre(pose, s3);
      CHECK((machine.centre(pose, r3) - b3).norm() < 1e-14);
      CHECK(std::abs((r * axis).dot(b3_from_base)) < 1e-14);
    }
  }
}

TEST_CASE("crossed rods drive the other ends of the upper beam, at the same pose of the platform") {
  const Machine plain = make_two_q_spr(), crossed = make_two_q_spr({{"rods_2", {1}}});
  std::mt19937_64 random(93);
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random_pose(plain, random);
    CAPTURE(q.transpose());
    const Pose a = reachable(plain, q), b = reachable(crossed, q);
    const auto apart = [&](const char* joint, const char* other) {
      return (plain.centre(a, test::joint_named(plain, joint)) - crossed.centre(b, test::joint_named(crossed, other))).norm();
    };
    CHECK((plain.origin(a, plain.topology().platform) - crossed.origin(b, crossed.topology().platform)).norm() < 1e-15);
    for (const char* joint : {"Rb11", "Rb12", "RB21", "RB22", "R24", "R3"}) CHECK(apart(joint, joint) < 1e-15);
    CHECK(apart("Rb21", "Rb22") < 1e-15);
    CHECK(apart("Rb22", "Rb21") < 1e-15);
    CHECK(apart("Rb21", "Rb21") == Approx(0.025));  // the beam's length, 2 d
  }
}

TEST_CASE("a limb's four pins lie in one plane, the upper beam across the platform's normal") {
  const Machine machine = make_two_q_spr();
  std::mt19937_64 random(94);
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random_pose(machine, random);
    CAPTURE(q.transpose());
    const Pose pose = reachable(machine, q);
    for (const std::string limb : {"1", "2"}) {
      const auto at = [&](const std::string& joint) { return machine.centre(pose, test::joint_named(machine, joint)); };
      const Vector3d low = at("RB" + limb + "1") - at("RB" + limb + "2"), high = at("Rb" + limb + "1") - at("Rb" + limb + "2"),
                     up = at("R" + limb + "4") - at("R" + limb + "1");
      CHECK(low.norm() == Approx(0.080));
      CHECK(high.norm() == Approx(0.025));
      CHECK(low.dot(high) > 0);                          // uncrossed
      CHECK(std::abs(low.cross(up).dot(high)) < 1e-15);  // one plane
      CHECK(std::abs(high.dot(machine.rotation(pose, machine.topology().platform).col(2))) < 1e-15);
    }
  }
}

TEST_CASE("a hinge that is not across the SPR limb at home is refused with the direction of the limb") {
  CHECK_THAT(refusal({{"revolute_axis", {std::sqrt(0.75), 0.5, 0}}}),  // radial
             Catch::StartsWith("home cannot be assembled") && Catch::Contains("(0.06, 0.034641, 0.3)"));
  CHECK(refusal({{"revolute_axis", {0.3, 0, -0.06}}}) == "revolute_axis must not be perpendicular to y, the dependent coordinate");
  CHECK(refusal({{"stroke_min", {0.5}}}) == "stroke_min must be less than stroke_max");
}

TEST_CASE("poses that leave a part of the 2Q-SPR open are out of reach, and say which") {
  const Machine machine = make_two_q_spr();
  const auto why = [&](const std::vector<double>& q) {
    const Pose pose = machine.pose(q);
    CHECK(pose.status == PM_UNREACHABLE);
    return pose.why;
  };
  // The hinge R3 stands at an azimuth of -60 degrees: at a yaw of 60 degrees it lies along x, and y is free.
  CHECK_THAT(why({0, 0.3, 60 * deg, 0, 0}), Catch::Contains("y, which it no longer determines"));
  // Yawed by -30 and pitched by 90 degrees, the platform turns its normal along O B1. With x = 31.2 mm the SPR limb's hinge puts b1
  // straight over B1, so that the plane of limb 1, through n1, is across O B1 as well.
  CHECK_THAT(why({0.0312, 0.1, -30 * deg, 90 * deg, 0}), Catch::Contains("parallel to the plane of a planar limb"));
}
