// Momentum and energy of moving bodies.
#include <core/mechanics/dynamics/momentum.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <tests/mechanics/massive.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double rounding = 1e-13;
const test::RotorNumbers rotor;

// Momentum and moment of momentum of body i about `fixed`, a point of the base.
Vector6d momentum(const Machine& machine, const State& s, std::size_t i, const Vector3d& fixed) {
  const Inertia& inertia = machine.topology().bodies[i].inertia;
  const BodyState& b = s.bodies[i];
  const Vector3d c = b.rotation * inertia.centre, p = inertia.mass * (b.velocity + b.angular_velocity.cross(c));
  const Vector3d spin = b.rotation * inertia.about_centre * b.rotation.transpose() * b.angular_velocity;
  return (Vector6d() << p, (b.origin + c - fixed).cross(p) + spin).finished();
}

}  // namespace

TEST_CASE("what a body demands is the change of its momentum") {
  constexpr double h = 1e-3, tolerance = 1e-8;  // differences of fourth order at rates of about one a second
  std::mt19937_64 random(61);
  const Machine machines[] = {test::make_rotor(), test::make_engine(), test::make(test::slider_crank())};
  for (const Machine& machine : machines)
    for (int k = 0; k < 10; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      const State s = motion.state(machine);
      const VectorXd demanded = inertial_wrenches(machine, s);
      for (std::size_t i = 1; i < s.bodies.size(); ++i) {
        INFO(machine.info().name << ", body " << machine.topology().bodies[i].name << ", q = " << motion.q.transpose());
        const auto then = [&](double t) { return momentum(machine, motion.state(machine, t), i, s.bodies[i].origin); };
        const Vector6d change = (8.0 * (then(h) - then(-h)) - (then(2 * h) - then(-2 * h))) / (12 * h);
        const Vector6d seen = demanded.segment<6>(6 * static_cast<Eigen::Index>(i) - 6);
        CHECK((seen - change).norm() < tolerance * std::max(1.0, change.norm()));
      }
    }
}

TEST_CASE("an unbalanced rotor pulls at its axis as the textbooks say") {
  const Machine machine = test::make_rotor();
  const double theta = 0.7, w = 5, e = 11;
  const State s = test::state_of(machine, theta, w, e);
  const Vector6d demanded = inertial_wrenches(machine, s);
  const Eigen::AngleAxisd turn(theta, Vector3d::UnitZ());
  const double x = rotor.centre.x(), y = rotor.centre.y();
  const Vector3d force = rotor.mass * Vector3d(-x * w * w - y * e, -y * w * w + x * e, 0);
  // With H = (xz, yz, zz) w in turning axes: H' + w x H.
  const Vector3d about_o(rotor.xz * e - rotor.yz * w * w, rotor.yz * e + rotor.xz * w * w, rotor.zz * e);
  CHECK((demanded.head<3>() - turn * force).norm() < rounding * force.norm());
  const Vector3d seen = demanded.tail<3>() + s.bodies[1].origin.cross(demanded.head<3>());
  CHECK((seen - turn * about_o).norm() < rounding * about_o.norm());
  CHECK(kinetic_energy(machine, s) == Approx(0.5 * rotor.zz * w * w).epsilon(rounding));
}

TEST_CASE("a body that falls freely demands its weight and nothing else") {
  const Machine machine = test::make_rotor();
  const Vector3d gravity(1.5, -2.5, -9.2);
  State s = test::state_of(machine, -0.4, 0, 0);
  s.bodies[1].velocity = {3, 4, -5};
  s.bodies[1].acceleration = gravity;
  const VectorXd weight = applied_wrenches(machine, s, {Vector6d::Zero(), gravity});
  CHECK((inertial_wrenches(machine, s) - weight).norm() < rounding * weight.norm());
  // It acts through the centre of mass.
  const Vector3d c = Eigen::AngleAxisd(-0.4, Vector3d::UnitZ()) * (rotor.centre - test::Rotor<1>::origin());
  CHECK((weight.head<3>() - rotor.mass * gravity).norm() < rounding * weight.norm());
  CHECK((weight.tail<3>() - c.cross(rotor.mass * gravity)).norm() < rounding * weight.norm());
}

TEST_CASE("the load acts on the platform alone, beside the weights") {
  const Machine machine = test::make_engine();
  const State s = test::state_of(machine, 1.1, 0, 0);
  const Vector6d load = (Vector6d() << 1, -2, 3, 4, -5, 6).finished();
  const Vector3d gravity(0, -9.81, 0);
  const VectorXd both = applied_wrenches(machine, s, {load, gravity}),
                 weights_alone = applied_wrenches(machine, s, {Vector6d::Zero(), gravity});
  VectorXd expected = VectorXd::Zero(18);
  expected.tail<6>() = load;
  CHECK((both - weights_alone - expected).norm() < rounding * both.norm());
  const double masses[] = {test::Engine::crank_mass, test::Engine::rod_mass, test::Engine::piston_mass};
  for (int i = 0; i < 3; ++i) CHECK(weights_alone(6 * i + 1) == Approx(-9.81 * masses[i]).epsilon(rounding));
}

TEST_CASE("potential energy is weight times height, and zero at the base's origin") {
  const Machine machine = test::make_rotor();
  for (const double theta : {-1.0, 0.0, 2.0}) {
    const State s = test::state_of(machine, theta, 3, 0);
    const double height = std::sin(theta) * rotor.centre.x() + std::cos(theta) * rotor.centre.y();  // along y
    CHECK(potential_energy(machine, s, {0, -9.81, 0}) == Approx(rotor.mass * 9.81 * height).epsilon(rounding));
    CHECK(potential_energy(machine, s, Vector3d::Zero()) == 0);
  }
}

TEST_CASE("a body's mass matrix gives its kinetic energy, and its demand from rest") {
  std::mt19937_64 random(62);
  std::uniform_real_distribution<double> any(-1, 1);
  const Machine machine = test::make_rotor();
  const Inertia& inertia = machine.topology().bodies[1].inertia;
  for (int k = 0; k < 20; ++k) {
    State s = test::state_of(machine, 3 * any(random), 0, 0);
    BodyState& b = s.bodies[1];
    const Matrix6d m = mass_matrix(inertia, b);
    CHECK((m - m.transpose()).norm() < rounding * m.norm());
    Vector6d v;
    for (double& x : v) x = any(random);
    b.acceleration = v.head<3>(), b.angular_acceleration = v.tail<3>();
    CHECK((m * v - inertial_wrenches(machine, s)).norm() < rounding * m.norm());
    b.velocity = v.head<3>(), b.angular_velocity = v.tail<3>();
    CHECK(0.5 * v.dot(m * v) == Approx(kinetic_energy(machine, s)).epsilon(rounding));
  }
}
