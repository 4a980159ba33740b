// Jacobian, mobility and statics of the Par4, against differences in extended precision and elementary mechanics.
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/numbers.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/par4.hpp>

#include <Eigen/LU>
#include <memory>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Matrix4d, Eigen::Vector3d, Eigen::Vector4d;

namespace {

constexpr double par4_gravity = 9.81;

std::unique_ptr<Machine> machine_with(const std::map<std::string, std::vector<double>>& changes = {}) {
  return std::make_unique<Machine>(test::par4(), test::values_with(test::par4(), changes));
}

ClosedForm par4_form_at(const Machine& machine, const Vector4d& q) {
  return closed_form(machine, test::par4_at(machine, q), characteristic_length(machine));
}

// d theta_i / d (x, y, z, theta) by central differences in extended precision: with h = 1e-6 their error is some h^2 = 1e-12.
Matrix4d par4_differences(const Machine& machine, const Vector4d& q) {
  constexpr double h = 1e-6;
  const std::size_t n = machine.layout().size();
  Matrix4d out;
  for (int k = 0; k < 4; ++k) {
    Eigen::Vector<long double, 4> side[2];
    for (const int sign : {0, 1}) {
      double parts[8] = {q(0), 0, q(1), 0, q(2), 0, q(3), 0};  // high and low
      parts[2 * k + 1] = sign == 0 ? -h : h;
      std::vector<double> x(2 * n);
      REQUIRE(machine.place(PM_EXTENDED, 1, parts, x.data()) == PM_OK);
      for (int i = 0; i < 4; ++i) {
        const std::size_t at = 2 * machine.layout().actuator(i);
        side[sign](i) = static_cast<long double>(x[at]) + static_cast<long double>(x[at + 1]);
      }
    }
    out.col(k) = ((side[1] - side[0]) / (2.0L * h)).cast<double>();
  }
  return out;
}

// Height of the tool over four equal arms with the plate square, by Pythagoras: rods from the elbows in to the plate's axis.
double par4_height(const test::Par4Sizes& s, double theta) {
  const double across = s.base + s.arm * std::cos(theta) - s.platform;
  return -s.arm * std::sin(theta) - std::sqrt(s.rod * s.rod - across * across);
}
double par4_slope(const test::Par4Sizes& s, double theta) { return (par4_height(s, theta + 1e-5) - par4_height(s, theta - 1e-5)) / 2e-5; }
constexpr double of_par4_slope = 1e-8;  // relative; of a difference over 2e-5 rad

}  // namespace

TEST_CASE("the Jacobian of the Par4 is the derivative of its inverse displacement") {
  const auto square = machine_with(), skew = machine_with({{"plate_angle", {60 * deg}}, {"elbow2", {1}}});
  for (const Machine* machine : {square.get(), skew.get()})
    for (const Eigen::VectorXd& q : random_poses(*machine, 50, 31)) {
      const Matrix4d expected = par4_differences(*machine, q);
      const Matrix6d g = par4_form_at(*machine, q).jacobian;
      Matrix4d seen;  // the tool turns about Z alone
      seen << g.topLeftCorner<4, 3>(), g.topRightCorner<4, 1>();
      CAPTURE(q.transpose());
      test::check_equal("d theta_i / d q", seen.reshaped(), expected.reshaped());
      // Below: no tilt.
      CHECK(g.bottomLeftCorner<2, 3>().isZero(0));
      CHECK(g.bottomRightCorner<2, 3>() == Eigen::Matrix3d::Identity().topRows<2>());
    }
}

TEST_CASE("the matrices of the Par4's closure give the same Jacobian") {
  const auto machine = machine_with();
  const Vector4d q(0.12, -0.07, -0.8, 25 * deg);
  const std::vector<Eigen::MatrixXd> m = machine->matrices({q.data(), 4}, machine->pose({q.data(), 4}));
  REQUIRE(m.size() == 2);
  const Matrix4d seen = -m[1].inverse() * m[0], expected = par4_differences(*machine, q);
  test::check_equal("-B^-1 A", seen.reshaped(), expected.reshaped());
}

// 17 links and 24 joints with 56 freedoms: 6 (17 - 24 - 1) + 56 - 8 = 0, while it has four. Three constraints too many are those of a plane
// four-bar, whose hinges are parallel without having to be; one is the fourth couple of the rods on three rotations of the plate.
TEST_CASE("the Par4 has four freedoms, eight idle spins and four constraints too many, everywhere") {
  const auto machine = machine_with();
  std::vector<Eigen::VectorXd> poses = random_poses(*machine, 20, 32);
  poses.push_back(machine->home());
  for (const Eigen::VectorXd& q : poses) {
    const Mobility m = mobility(*machine, test::par4_at(*machine, q));
    CAPTURE(q.transpose());
    CHECK(m.bodies == 17);
    CHECK(m.joints == 24);
    CHECK(m.freedoms_sum == 56);
    CHECK(m.gruebler == 0);
    CHECK(m.redundant == 4);
    CHECK(m.freedoms == 4);
    CHECK(m.idle == 8);
  }
}

TEST_CASE("four equal motors of the Par4 hold a weight by virtual work") {
  const test::Par4Sizes s;
  const auto machine = machine_with();
  for (const double theta : {-20 * deg, 0.0, 35 * deg}) {
    const ClosedForm g = par4_form_at(*machine, {0, s.half_hinges, par4_height(s, theta), 0});
    const Vector6d weight = (Vector6d() << 0, 0, -10, 3, -2, 0).finished();  // its tilt is held by the rods, not by the motors
    const Vector6d forces = closed_statics(g, weight);
    for (int i = 0; i < 4; ++i)
      CHECK(forces(i) == Approx(10 * par4_slope(s, theta) / 4).epsilon(of_par4_slope));  // negative: it raises the arm
  }
}

TEST_CASE("the Par4's own weight on its motors follows from the heights of its centres of mass") {
  // Four bodies of the plate, 0.3 kg each, all level; arms of 1 kg, halfway; eight rods of 0.1 kg, halfway from elbow to plate.
  const test::Par4Sizes s;
  const auto machine = machine_with();
  for (const double theta : {-20 * deg, 0.0, 35 * deg}) {
    const State state = test::par4_at(*machine, {0, s.half_hinges, par4_height(s, theta), 0});
    const Vector3d down(0, 0, -par4_gravity);
    const Eigen::VectorXd all_bodies = generic_statics(generic_model(*machine, state), weights(*machine, state, down)).actuator_forces;
    const Eigen::VectorXd by_partials = weight_forces(*machine, state, down);
    const double elbow = -s.arm * std::cos(theta), plate = par4_slope(s, theta);  // by theta
    const double power = 4 * 0.3 * plate + 4 * 1.0 * elbow / 2 + 8 * 0.1 * (elbow + plate) / 2;
    for (int i = 0; i < 4; ++i) {
      CHECK(all_bodies(i) == Approx(par4_gravity * power / 4).epsilon(of_par4_slope));
      CHECK(by_partials(i) == Approx(par4_gravity * power / 4).epsilon(of_par4_slope));
    }
  }
}

// At home a bar pushes the halves apart by M / 2a, along Y. Each half hands its push to two rods, which lean inwards by 45 degrees to it
// and down: with arms level a motor of lever L feels the rods' downward share alone. Along a rod of slope w = across / l the push of half a
// half is f = (M / 4a) / (w cos 45), and the torque L f sqrt(1 - w^2).
TEST_CASE("a couple about Z on the Par4's tool is held by motors that pull to and fro") {
  const test::Par4Sizes s;
  const auto machine = machine_with();
  const double couple = 2, w = (s.base + s.arm - s.platform) / s.rod, c45 = std::numbers::sqrt2 / 2;
  const double torque = s.arm * couple / (4 * s.half_bar) / (w * c45) * std::sqrt(1 - w * w);
  const Vector6d load = (Vector6d() << 0, 0, 0, 0, 0, couple).finished();
  const Vector6d forces = closed_statics(par4_form_at(*machine, machine->home()), load);
  for (int i = 0; i < 4; ++i) CHECK(std::abs(forces(i)) == Approx(torque).epsilon(1e-12));
  CHECK(forces(0) == Approx(-forces(1)));
  CHECK(forces(1) == Approx(-forces(2)));
  CHECK(forces(2) == Approx(-forces(3)));
}

// What bar and halves hand to the rods, found on all bodies: the same motors hold any load whatever the plate does with it.
TEST_CASE("all bodies of the Par4 together ask the same of the motors as its Jacobian") {
  const auto machine = machine_with({{"plate_angle", {75 * deg}}});
  std::mt19937_64 random(33);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  for (const Eigen::VectorXd& q : random_poses(*machine, 20, 34)) {
    Vector6d load;
    for (int k = 0; k < 6; ++k) load(k) = symmetric(random) * (k < 3 ? 10 : 1);
    const State state = test::par4_at(*machine, q);
    const ClosedForm g = closed_form(*machine, state, characteristic_length(*machine));
    test::check_equal("torques", generic_statics(*machine, generic_model(*machine, state), load).actuator_forces,
                      closed_statics(g, load).head<4>());
  }
}
