// What the P(2PRPU)/PRPS's geometry says in closed form: the ends of its workspace, its determinant and transmission at zero tilt, its
// mobility, and the direction of its constraint.
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/p2prpu_prps.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double rounding_of_p2prpu_prps = 1e-12;
constexpr double gauge = 1.2, width = 0.4, arm = 0.24, shortest = 0.99, longest = 1.49;  // [m] the paper's

VectorXd pose(double x, double y, double z, double alpha = 0, double beta = 0) { return (VectorXd(5) << x, y, z, alpha, beta).finished(); }

std::unique_ptr<Machine> machine_with(double side = 0) {
  return std::make_unique<Machine>(test::p2prpu_prps(), test::values_with(test::p2prpu_prps(), {{"sigma", {side}}}));
}

VectorXd random_pose(std::mt19937_64& random) {
  const auto in = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  return pose(in(0.6, 1.0), in(-0.3, 0.3), in(0.95, 1.35), in(-0.15, 0.15), in(-0.15, 0.15));
}

}  // namespace

TEST_CASE("at zero tilt the P(2PRPU)/PRPS meets its limits where its triangles say") {
  const auto machine = machine_with();
  const auto length = [&](const VectorXd& q, std::size_t limb) { return test::state_at(*machine, q).actuators[1 + limb].value; };
  const double lean = (gauge - width) / 2;  // of limbs 2 and 3 across, at y = 0
  SECTION("lowest: limbs 2 and 3 at their shortest") {
    const VectorXd q = pose(0.8, 0, std::sqrt(shortest * shortest - lean * lean));
    CHECK(length(q, 2) == Approx(shortest).epsilon(rounding_of_p2prpu_prps));
    CHECK(length(q, 3) == Approx(shortest).epsilon(rounding_of_p2prpu_prps));
  }
  SECTION("highest: limbs 2 and 3 at their longest") {
    const VectorXd q = pose(0.8, 0, std::sqrt(longest * longest - lean * lean));
    CHECK(length(q, 2) == Approx(longest).epsilon(rounding_of_p2prpu_prps));
    CHECK(length(q, 3) == Approx(longest).epsilon(rounding_of_p2prpu_prps));
  }
  SECTION("farthest along X: limb 1 at its longest, 30 degrees from the platform's normal") {
    const VectorXd q = pose(arm + longest * 0.5, 0, longest * std::sqrt(0.75));
    CHECK(length(q, 1) == Approx(longest).epsilon(rounding_of_p2prpu_prps));
    CHECK(test::reading(*machine, q, "S1_tilt") == Approx(30 * deg).epsilon(rounding_of_p2prpu_prps));
  }
  SECTION("farthest along Y: limb 3 at its longest, 30 degrees from the platform's normal") {
    const VectorXd q = pose(0.8, longest * 0.5 - lean, longest * std::sqrt(0.75));
    CHECK(length(q, 3) == Approx(longest).epsilon(rounding_of_p2prpu_prps));
    CHECK(test::reading(*machine, q, "U3_tilt") == Approx(30 * deg).epsilon(rounding_of_p2prpu_prps));
  }
}

TEST_CASE("with C1 away from its rail the paper's limits leave nothing at zero tilt") {
  // l_x >= 0.6 puts C1 at 0.84 or farther; 30 degrees and 1.49 m reach 0.745.
  const auto machine = machine_with(1);
  for (double z = 0.2; z < 1.6; z += 0.05) {
    const VectorXd q = pose(0.6, 0, z);
    CHECK((test::state_at(*machine, q).actuators[2].value > longest || test::reading(*machine, q, "S1_tilt") > 30 * deg));
  }
}

TEST_CASE("limits of the P(2PRPU)/PRPS's joints count from Z and from the platform's normal") {
  const auto machine = machine_with();
  const Closure closure(*machine);
  const auto check = [&](const VectorXd& q, const char* joint, bool at_max) {
    const int j = test::joint_named(*machine, joint);
    const Range limit = machine->topology().joints[static_cast<std::size_t>(j)].limits[0];
    CAPTURE(q.transpose(), joint);
    CHECK(closure.motion(test::state_at(*machine, q).bodies, j)[0] ==
          Approx(at_max ? limit.max : limit.min).margin(rounding_of_p2prpu_prps));
  };
  // Level poses at which a limb leans by an angle about its axis, Y or X.
  constexpr double z = 1.15, lean = (gauge - width) / 2;
  const auto limb1 = [&](double angle) { return pose(arm + z * std::tan(angle), 0, z); };
  const auto limb2 = [&](double angle) { return pose(0.8, lean - z * std::tan(angle), z); };
  const auto limb3 = [&](double angle) { return pose(0.8, -lean - z * std::tan(angle), z); };
  for (const bool positive : {false, true}) {
    const double sign = positive ? 1 : -1;
    check(limb1(sign * 60 * deg), "R11", positive);
    check(limb2(sign * 60 * deg), "R21", positive);
    check(limb3(sign * 60 * deg), "R31", positive);
    check(limb2(sign * 30 * deg), "U2", !positive);  // the platform turns the other way against the limb
    check(limb3(sign * 30 * deg), "U3", !positive);
  }
}

TEST_CASE("the declared cone of the P(2PRPU)/PRPS's ball holds all that its limit about the platform's normal allows") {
  const auto machine = machine_with();
  const Closure closure(*machine);
  const int ball = test::joint_named(*machine, "S1");
  const double cone = machine->topology().joints[static_cast<std::size_t>(ball)].limits[0].max;
  std::mt19937_64 random(5);
  int allowed = 0;
  for (int k = 0; k < 1000; ++k) {
    VectorXd q = random_pose(random);
    q(0) -= 0.5;  // limb 1 may lean to the other side than at home
    if (test::reading(*machine, q, "S1_tilt") > 30 * deg) continue;
    ++allowed;
    CHECK(closure.motion(test::state_at(*machine, q).bodies, ball)[0] <= cone);
  }
  CHECK(allowed > 100);
}

TEST_CASE("at zero tilt the transmission of the P(2PRPU)/PRPS is the cosine of each limb's lean, and its determinant their product") {
  std::mt19937_64 random(6);
  for (const double side : {0.0, 1.0}) {
    const auto machine = machine_with(side);
    for (int k = 0; k < 20; ++k) {
      VectorXd q = random_pose(random);
      q.tail<2>().setZero();
      const State s = test::state_at(*machine, q);
      double product = (side == 0 ? -1 : 1) * arm * width;
      for (std::size_t i = 0; i < 3; ++i) {
        const double cosine = q(2) / s.actuators[2 + i].value;
        CHECK(test::reading(*machine, q, "mu" + std::to_string(i + 1)) == Approx(cosine).epsilon(rounding_of_p2prpu_prps));
        product *= cosine;
      }
      CHECK(closed_form(*machine, s, 1.0).determinant == Approx(product).epsilon(rounding_of_p2prpu_prps));
    }
  }
}

TEST_CASE("the P(2PRPU)/PRPS has five freedoms and two constraints too many, everywhere") {
  std::mt19937_64 random(8);
  const auto machine = machine_with();
  for (int k = 0; k < 20; ++k) {
    const Mobility m = mobility(*machine, test::state_at(*machine, k == 0 ? machine->home() : random_pose(random)));
    CHECK(m.bodies == 10);
    CHECK(m.joints == 11);
    CHECK(m.freedoms_sum == 15);
    CHECK(m.gruebler == 3);
    CHECK(m.rows == 51);
    CHECK(m.redundant == 2);
    CHECK(m.freedoms == 5);
    CHECK(m.idle == 0);
  }
}

TEST_CASE("the constraint couple of the P(2PRPU)/PRPS is perpendicular to the universal joints, not to the platform") {
  // A turn about X alone, with beta not zero: along the platform's normal, as the paper has it, the couple would do work.
  const auto machine = machine_with();
  VectorXd rate = VectorXd::Zero(5);
  rate(3) = 1;
  const State s = test::state_at(*machine, pose(0.8, 0, 1.15, 4 * deg, 10 * deg), rate);
  const BodyState& platform = s.bodies[static_cast<std::size_t>(machine->topology().platform)];
  const Vector3d couple = closed_form(*machine, s, 1.0).jacobian.row(5).tail<3>();
  CHECK(std::abs(couple.dot(platform.angular_velocity)) < rounding_of_p2prpu_prps);
  CHECK(platform.rotation.col(2).dot(platform.angular_velocity) == Approx(std::sin(10 * deg)).epsilon(rounding_of_p2prpu_prps));
}
