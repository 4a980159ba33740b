// Jacobian, statics and singular poses of the Delta robot, against differences in extended precision and elementary mechanics.
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/delta.hpp>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double gravity = 9.81;

State rest_at(const Machine& machine, const Vector3d& p) {
  const Vector3d zero = Vector3d::Zero();
  State s;
  evaluate(machine, p.data(), zero.data(), zero.data(), s);
  REQUIRE(s.status == PM_OK);
  return s;
}
ClosedForm form_at(const Machine& machine, const Vector3d& p) {
  return closed_form(machine, rest_at(machine, p), characteristic_length(machine));
}

// d theta / d p by central differences in extended precision: with h = 1e-6 m their error is some h^2 = 1e-12.
Matrix3d differences(const Machine& machine, const Vector3d& p) {
  constexpr double h = 1e-6;
  const std::size_t n = machine.layout().size();
  Matrix3d out;
  for (int k = 0; k < 3; ++k) {
    Eigen::Vector<long double, 3> side[2];
    for (const int sign : {0, 1}) {
      double q[6] = {p(0), 0, p(1), 0, p(2), 0};  // high and low parts
      q[2 * k + 1] = sign == 0 ? -h : h;
      std::vector<double> x(2 * n);
      REQUIRE(machine.place(PM_EXTENDED, 1, q, x.data()) == PM_OK);
      for (int i = 0; i < 3; ++i) {
        const std::size_t at = 2 * machine.layout().actuator(i);
        side[sign](i) = static_cast<long double>(x[at]) + static_cast<long double>(x[at + 1]);
      }
    }
    out.col(k) = ((side[1] - side[0]) / (2.0L * h)).cast<double>();
  }
  return out;
}

// Height of the platform over three equal arms, by Pythagoras: rods from the elbows in to the platform's axis.
double height(const test::DeltaSizes& s, double theta) {
  const double across = s.base + s.arm * std::cos(theta) - s.platform;
  return -s.arm * std::sin(theta) - std::sqrt(s.rod * s.rod - across * across);
}
double slope(const test::DeltaSizes& s, double theta) { return (height(s, theta + 1e-5) - height(s, theta - 1e-5)) / 2e-5; }
constexpr double of_slope = 1e-8;  // relative; of a difference over 2e-5 rad

}  // namespace

TEST_CASE("the Jacobian of the Delta is the derivative of its inverse displacement") {
  std::mt19937_64 random(30);
  std::uniform_real_distribution<double> side(-0.3, 0.3), depth(-1.25, -0.9);
  for (const double elbow : {0.0, 1.0}) {
    const Machine machine(test::delta(), test::delta_values({}, test::all_elbows(elbow)));
    for (int k = 0; k < 50; ++k) {
      const Vector3d p(side(random), side(random), depth(random));
      const Matrix3d expected = differences(machine, p), seen = form_at(machine, p).jacobian.topLeftCorner<3, 3>();
      CAPTURE(p.transpose(), elbow);
      test::check_equal("d theta / d p", seen.reshaped(), expected.reshaped());
    }
  }
}

TEST_CASE("the matrices of the Delta's closure give the same Jacobian") {
  const Machine machine(test::delta(), test::delta_values({}));
  const Vector3d p(0.2, -0.1, -1.1);
  const std::vector<Eigen::MatrixXd> m = machine.matrices({p.data(), 3}, machine.pose({p.data(), 3}));
  REQUIRE(m.size() == 2);
  const Matrix3d seen = -m[1].inverse() * m[0], expected = differences(machine, p);
  test::check_equal("-B^-1 A", seen.reshaped(), expected.reshaped());
}

TEST_CASE("three equal motors of the Delta hold a weight by virtual work") {
  const test::DeltaSizes s;
  const Machine machine(test::delta(), test::delta_values(s));
  for (const double theta : {-20 * deg, 0.0, 35 * deg}) {
    const ClosedForm g = form_at(machine, {0, 0, height(s, theta)});
    const Vector6d weight = (Vector6d() << 0, 0, -10, 0, 0, 0).finished();
    const Vector6d forces = closed_statics(g, weight);
    for (int i = 0; i < 3; ++i) {
      CHECK(forces(i) == Approx(10 * slope(s, theta) / 3).epsilon(of_slope));  // negative: the motor raises the arm
      CHECK(std::abs(forces(3 + i)) < 1e-12);
    }
  }
}

TEST_CASE("the Delta's own weight on its motors follows from the heights of its centres of mass") {
  // Platform 0.6 kg at p; arms 1.2 kg, halfway; six rods of 0.14 kg, halfway from elbow to platform.
  const test::DeltaSizes s;
  const Machine machine(test::delta(), test::delta_values(s));
  for (const double theta : {-20 * deg, 0.0, 35 * deg}) {
    const State state = rest_at(machine, {0, 0, height(s, theta)});
    const Vector3d down(0, 0, -gravity);
    const Eigen::VectorXd all_bodies = generic_statics(generic_model(machine, state), weights(machine, state, down)).actuator_forces;
    const Eigen::VectorXd by_partials = weight_forces(machine, state, down);
    const double elbow = -s.arm * std::cos(theta), platform = slope(s, theta);  // by theta
    const double power = 0.6 * platform + 3 * 1.2 * elbow / 2 + 6 * 0.14 * (elbow + platform) / 2;
    for (int i = 0; i < 3; ++i) {
      CHECK(all_bodies(i) == Approx(gravity * power / 3).epsilon(of_slope));
      CHECK(by_partials(i) == Approx(gravity * power / 3).epsilon(of_slope));
    }
  }
}

TEST_CASE("turning the load about the platform's normals loads the rods of the Delta alone") {
  const Machine machine(test::delta(), test::delta_values({}));
  const ClosedForm g = form_at(machine, machine.home());
  const Vector6d couple = (Vector6d() << 0, 0, 0, 0, 0, 2).finished();
  const Vector6d forces = closed_statics(g, couple);
  // At home the couples of the limbs lean alike: c_z of each along Z is the horizontal share of the rod's unit vector.
  const test::DeltaSizes s;
  const double horizontal = (s.base + s.arm - s.platform) / s.rod;
  for (int i = 0; i < 3; ++i) {
    CHECK(std::abs(forces(i)) < 1e-12);
    CHECK(std::abs(forces(3 + i)) == Approx(2 / (3 * horizontal)).epsilon(1e-12));
  }
}

TEST_CASE("parallel rods make the Delta singular: the platform moves though the motors stand") {
  // A platform so wide that the rods hang straight down: R + L cos(theta) = r.
  const double theta = 75 * deg;
  const test::DeltaSizes s{0.2, 0.2 + 0.524 * std::cos(theta), 0.524, 1.244};
  const Machine machine(test::delta(), test::delta_values(s));
  const Vector3d p(0, 0, -s.arm * std::sin(theta) - s.rod);
  const ClosedForm beside = form_at(machine, p + Vector3d(0, 0, 0.2)), there = form_at(machine, p);
  CHECK(std::abs(there.determinant) < 1e-12 * std::abs(beside.determinant));
  // Not only the motors': the couples lie level, so the platform may also turn about Z.
  const Eigen::JacobiSVD<Matrix6d> svd(there.jacobian);
  CHECK(svd.singularValues()(2) > 1e-3);
  CHECK(svd.singularValues()(3) < 1e-12);
}

TEST_CASE("a stretched arm makes the Delta lose a direction: the motor turns though the platform stands") {
  const test::DeltaSizes s;
  const Machine machine(test::delta(), test::delta_values(s));
  const double across = s.base - s.platform, reach = s.arm + s.rod, lowest = -std::sqrt(reach * reach - across * across);
  // det B, the product of the motors' levers, goes to zero like the square root of the distance, three limbs at once.
  const auto levers = [&](double above) {
    const Vector3d p(0, 0, lowest + above);
    return std::abs(machine.matrices({p.data(), 3}, machine.pose({p.data(), 3}))[1].determinant());
  };
  CHECK(levers(1e-8) / levers(1e-6) == Approx(1e-3).epsilon(1e-3));
}
