// Displacement of the Par4 against plane triangles: the sphere that a rod draws about its wrist cuts the plane of the arm in a circle.
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/par4.hpp>

#include <Eigen/Geometry>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d, Eigen::Vector4d;

namespace {

constexpr double rounding_of_par4 = 1e-12;  // [m], [rad]; of lengths below 1 m

double angle_of_arm(const Machine& machine, const Pose& pose, int limb) { return pose.numbers[machine.layout().actuator(limb)]; }
Pose par4_pose_at(const Machine& machine, const Vector4d& q) { return machine.pose({q.data(), 4}); }

// By the law of cosines in the triangle of motor, elbow and wrist, the rods seen along the motor's axis. An elbow that is out lies above
// the line from motor to wrist, one that is in below.
double by_triangle(const test::Par4Sizes& s, int limb, const Vector3d& wrist, bool out) {
  const Vector3d d = wrist - s.base * test::outwards(limb);
  const double aside = d.dot(test::along_motor(limb)), across = d.dot(test::outwards(limb)), down = -d.z();
  const double rod = std::sqrt(s.rod * s.rod - aside * aside), line = std::hypot(across, down);
  const double at_motor = std::acos((s.arm * s.arm + line * line - rod * rod) / (2 * s.arm * line));
  return std::atan2(down, across) + (out ? -at_motor : at_motor);
}

}  // namespace

TEST_CASE("the Par4's arms stand as the triangles of motor, elbow and wrist demand") {
  const test::Par4Sizes s;
  for (const bool out : {true, false}) {
    std::map<std::string, std::vector<double>> changes;
    for (int i = 1; i <= 4; ++i) changes["elbow" + std::to_string(i)] = {out ? 0.0 : 1.0};
    const Machine machine(test::par4(), test::values_with(test::par4(), changes));
    for (const Eigen::VectorXd& q : random_poses(machine, 100, 3)) {
      const Pose pose = par4_pose_at(machine, q);
      for (int i = 0; i < 4; ++i) {
        CAPTURE(q.transpose(), out, i);
        const double expected = by_triangle(s, i, test::wrist(s, i, q.head<3>(), q(3)), out);
        CHECK(std::abs(std::remainder(angle_of_arm(machine, pose, i) - expected, 2 * std::numbers::pi)) < rounding_of_par4);
      }
    }
  }
}

// Turned by 90 degrees the bars bring the wrists of half 1 by 55 mm inwards and 55 mm aside: 55 sqrt 2 mm at 135 degrees, which for limb 2,
// at 45 degrees, is along its motor's axis, for limb 1 straight inwards.
TEST_CASE("a quarter turn of the Par4's tool moves wrists by hand-made amounts") {
  const test::Par4Sizes s;
  const Machine machine(test::par4(), test::values_with(test::par4(), {}));
  const double z = -0.7, shift = 0.055 * std::numbers::sqrt2, down = 0.7;
  const Pose pose = par4_pose_at(machine, {0, 0.05, z, 90 * deg});
  REQUIRE(pose.status == PM_OK);
  // Motor to wrist, across: r - R for limbs 2 and 4, less the shift for 1 and 3.
  const double square_rod = s.rod * s.rod - shift * shift, far = s.platform - s.base, near = far - shift;
  const auto angle = [&](double across, double rod2) {
    const double line2 = across * across + down * down;
    return std::atan2(down, across) - std::acos((s.arm * s.arm + line2 - rod2) / (2 * s.arm * std::sqrt(line2)));
  };
  for (const int limb : {1, 3}) CHECK(angle_of_arm(machine, pose, limb) == Approx(angle(far, square_rod)).epsilon(rounding_of_par4));
  for (const int limb : {0, 2}) CHECK(angle_of_arm(machine, pose, limb) == Approx(angle(near, s.rod * s.rod)).epsilon(rounding_of_par4));
}

TEST_CASE("at home the Par4's arms are level and the middle of its plate is under the base's") {
  const test::Par4Sizes s;
  const Machine machine(test::par4(), test::values_with(test::par4(), {}));
  const double across = s.base + s.arm - s.platform;
  CHECK(machine.home()(0) == Approx(0).margin(rounding_of_par4));
  CHECK(machine.home()(1) == Approx(s.half_hinges).epsilon(rounding_of_par4));
  CHECK(machine.home()(2) == Approx(-std::sqrt(s.rod * s.rod - across * across)).epsilon(rounding_of_par4));
  for (int i = 0; i < 4; ++i) CHECK(std::abs(angle_of_arm(machine, machine.home_pose(), i)) < rounding_of_par4);
}

TEST_CASE("the bodies of the Par4's plate keep their lengths, and the bars turn with the tool") {
  const double skew = 70 * deg;
  const Machine machine(test::par4(), test::values_with(test::par4(), {{"plate_angle", {skew}}}));
  const test::Par4Sizes s;
  const int h[] = {test::joint_named(machine, "H1"), test::joint_named(machine, "H2"), test::joint_named(machine, "H3"),
                   test::joint_named(machine, "H4")};
  for (const Eigen::VectorXd& q : random_poses(machine, 20, 4)) {
    const Pose pose = par4_pose_at(machine, q);
    const auto from_to = [&](int i, int k) -> Vector3d { return machine.centre(pose, h[k]) - machine.centre(pose, h[i]); };
    CAPTURE(q.transpose());
    const Vector3d bar = 2 * s.half_bar * Vector3d(std::cos(q(3)), std::sin(q(3)), 0);
    const Vector3d line = 2 * s.half_hinges * Vector3d(std::cos(skew), std::sin(skew), 0);
    for (const auto& [from, to] : {std::pair{1, 0}, std::pair{3, 2}}) CHECK((from_to(from, to) - bar).norm() < rounding_of_par4);
    for (const auto& [from, to] : {std::pair{2, 0}, std::pair{3, 1}}) CHECK((from_to(from, to) - line).norm() < rounding_of_par4);
    CHECK((0.5 * (machine.centre(pose, h[0]) + machine.centre(pose, h[1])) - q.head<3>()).norm() < rounding_of_par4);
  }
}

TEST_CASE("forward displacement of the Par4 returns the pose") {
  const Machine machine(test::par4(), test::values_with(test::par4(), {}));
  ForwardSolver forward(machine);
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  for (int k = 0; k < 50; ++k) {
    const Vector4d q(0.15 * symmetric(random), 0.05 + 0.15 * symmetric(random), -0.75 + 0.1 * symmetric(random), 0.7 * symmetric(random));
    const Pose pose = par4_pose_at(machine, q);
    REQUIRE(pose.status == PM_OK);
    Eigen::VectorXd theta(4);
    for (int i = 0; i < 4; ++i) theta(i) = angle_of_arm(machine, pose, i);
    const ForwardSolution found = forward.solve(theta, machine.home());
    CAPTURE(q.transpose(), found.why);
    REQUIRE(found.outcome == Outcome::good);
    CHECK((found.coordinates - q).norm() < 1e-10);  // Newton's last step is quadratic in one below it
  }
}

TEST_CASE("sizes from which the Par4 cannot be assembled are refused with what to change") {
  const auto refusal = [](const std::map<std::string, std::vector<double>>& changes) -> std::string {
    try {
      const Machine machine(test::par4(), test::values_with(test::par4(), changes));
    } catch (const MechanismError& e) {
      CHECK(e.status == PM_BAD_ARGUMENT);
      return e.what();
    }
    return "";
  };
  CHECK(refusal({{"rod_length", {0.55}}}) ==
        "home has level arms, from whose elbows the rods must hang: rod_length must be above 0.561224 m");
  CHECK(refusal({{"arm_highest", {1.0}}, {"arm_lowest", {0.5}}}) == "arm_highest must be less than arm_lowest: theta lowers the arm");
}
