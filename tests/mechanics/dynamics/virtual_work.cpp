// Dynamics in the independent coordinates, against machines whose equations of motion stand in the textbooks.
#include <core/mechanics/dynamics/virtual_work.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <tests/mechanics/massive.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {
constexpr double work_rounding = 1e-12;
const test::RotorNumbers work_rotor;
}  // namespace

TEST_CASE("the tangent times the coordinates' rates gives twists and actuator rates") {
  std::mt19937_64 random(71);
  const Machine machines[] = {test::make(test::hexapod()), test::make(test::arm()), test::make(test::four_bar()),
                              test::make(test::slider_crank()), test::make_engine()};
  for (const Machine& machine : machines)
    for (int k = 0; k < 10; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      INFO(machine.info().name << ", q = " << motion.q.transpose());
      const State s = motion.state(machine);
      const Tangent t = tangent(machine, s);
      const VectorXd twists = stacked_twists(s);
      CHECK((t.bodies * motion.rate - twists).norm() < work_rounding * twists.norm());
      for (int i = 0; i < machine.dof(); ++i)
        CHECK(t.actuators.row(i).dot(motion.rate) == Approx(s.actuators[static_cast<std::size_t>(i)].rate).margin(work_rounding));
    }
}

TEST_CASE("a physical pendulum") {
  // J theta'' = tau + moment of the weight about the axis.
  const Machine machine = test::make_rotor();
  const double theta = 0.6, w = 4, e = -7, g = 9.81;
  const State s = test::state_of(machine, theta, w, e);
  const Tangent t = tangent(machine, s);
  const Vector3d gravity(0, -g, 0);
  const double arm = std::cos(theta) * work_rotor.centre.x() - std::sin(theta) * work_rotor.centre.y();  // of the weight, along x
  const Vector6d load = (Vector6d() << 0, 0, 0, 0, 0, 2.5).finished();

  const EquationsOfMotion eq = equations_of_motion(machine, s, t, gravity);
  CHECK(eq.mass(0, 0) == Approx(work_rotor.zz).epsilon(work_rounding));
  CHECK(std::abs(eq.coriolis(0)) < work_rounding * work_rotor.zz * w * w);
  CHECK(eq.gravity(0) == Approx(work_rotor.mass * g * arm).epsilon(work_rounding));
  CHECK(reflected_inertia(t, eq.mass)(0) == Approx(work_rotor.zz).epsilon(work_rounding));

  const ForceShares shares = virtual_work(machine, s, t, {load, gravity});
  CHECK(shares.inertia(0) == Approx(work_rotor.zz * e).epsilon(work_rounding));
  CHECK(shares.gravity(0) == Approx(work_rotor.mass * g * arm).epsilon(work_rounding));
  CHECK(shares.load(0) == Approx(-2.5).epsilon(work_rounding));
  CHECK(shares.total()(0) == Approx(work_rotor.zz * e + work_rotor.mass * g * arm - 2.5).epsilon(work_rounding));

  // Let go, it falls: no torque.
  const State free = test::state_of(machine, theta, w, -work_rotor.mass * g * arm / work_rotor.zz);
  CHECK(std::abs(virtual_work(machine, free, t, {Vector6d::Zero(), gravity}).total()(0)) < work_rounding * work_rotor.mass * g);
}

TEST_CASE("the torque of an engine's crank follows from its energy") {
  // T = M(theta) theta'^2 / 2 with M = J + sum of m (dc/dtheta)^2 + I (dphi/dtheta)^2, sin(phi) = r sin(theta) / l.
  using E = test::Engine;
  const auto velocities = [](double theta) {
    const double phi = std::asin(E::r * std::sin(theta) / E::l), phi_1 = E::r * std::cos(theta) / (E::l * std::cos(phi));
    const double gx = -E::r * std::sin(theta) - E::rod_centre * std::sin(phi) * phi_1;
    const double gy = E::r * std::cos(theta) - E::rod_centre * std::cos(phi) * phi_1;
    const double x = -E::r * std::sin(theta) - E::l * std::sin(phi) * phi_1;
    return std::array{phi_1, gx, gy, x};
  };
  const auto mass = [&](double theta) {
    const auto [phi, gx, gy, x] = velocities(theta);
    return E::crank_inertia + E::crank_mass * E::crank_centre * E::crank_centre + E::rod_inertia * phi * phi +
           E::rod_mass * (gx * gx + gy * gy) + E::piston_mass * x * x;
  };
  const Machine machine = test::make_engine();
  const double w = 30, e = 400, gas = -800, g = 9.81;
  for (const double theta : {0.4, 1.2, 2.0, 2.7}) {
    CAPTURE(theta);
    constexpr double h = 1e-3;  // fourth order: 1e-12 of M
    const double slope = (8 * (mass(theta + h) - mass(theta - h)) - (mass(theta + 2 * h) - mass(theta - 2 * h))) / (12 * h);
    const State s = test::state_of(machine, theta, w, e);
    const Tangent t = tangent(machine, s);
    const EquationsOfMotion eq = equations_of_motion(machine, s, t, {0, -g, 0});
    const auto [phi, gx, gy, x] = velocities(theta);
    const double of_weight = E::crank_mass * g * E::crank_centre * std::cos(theta) + E::rod_mass * g * gy;
    CHECK(eq.mass(0, 0) == Approx(mass(theta)).epsilon(work_rounding));
    CHECK(std::abs(eq.coriolis(0) - 0.5 * slope * w * w) < 1e-9 * mass(theta) * w * w);
    CHECK(eq.gravity(0) == Approx(of_weight).epsilon(work_rounding));
    const ForceShares shares = virtual_work(machine, s, t, {(Vector6d() << gas, 0, 0, 0, 0, 0).finished(), {0, -g, 0}});
    CHECK(shares.load(0) == Approx(-gas * x).epsilon(work_rounding));
    CHECK(shares.gravity(0) == Approx(of_weight).epsilon(work_rounding));
    CHECK(std::abs(shares.inertia(0) - mass(theta) * e - 0.5 * slope * w * w) < 1e-9 * mass(theta) * w * w);
  }
}

TEST_CASE("an actuator feels the inertia of all that it moves, through the square of the ratio") {
  // The slider of the spatial slider-crank drives its crank: s' = (ds/dtheta) theta', and energy is the same on either side.
  const Machine machine = test::make(test::slider_crank());
  const State s = test::state_of(machine, 0.9, 1.0, 0);
  const Tangent t = tangent(machine, s);
  const double reflected = reflected_inertia(t, equations_of_motion(machine, s, t, Vector3d::Zero()).mass)(0);
  const double rate = s.actuators[0].rate;
  CHECK(0.5 * reflected * rate * rate == Approx(kinetic_energy(machine, s)).epsilon(work_rounding));
}

TEST_CASE("shares of what is not there are zero") {
  const Machine machine = test::make_engine();
  const State still = test::state_of(machine, 1.0, 0, 0);
  const ForceShares shares = virtual_work(machine, still, tangent(machine, still), {});
  CHECK(shares.load(0) == 0);
  CHECK(shares.gravity(0) == 0);
  CHECK(shares.inertia(0) == 0);
}
