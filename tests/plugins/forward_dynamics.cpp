// Motions from forces of real mechanisms: inverse dynamics gives the forces back, energy adds up, and springs settle where statics says.
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/forward_dynamics/forward_dynamics.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <tests/plugins/plugin.hpp>

#include <catch2/catch.hpp>

#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

Machine machine_of(const std::string& name) {
  const pm_mechanism& table = test::plugin(name);
  return Machine(table, default_values(describe(table)));
}

// Springs and dampers at the actuators about their values at home, a load that turns, gravity; a start off home, with rates.
ForwardProblem shaken(const Machine& machine, double duration, int samples) {
  const Pose home = machine.home_pose();
  const Layout layout = machine.layout();
  ForwardProblem p;
  p.actuator_forces = [home, layout](double t, const std::vector<Scalar>& actuators, double* forces) {
    for (std::size_t i = 0; i < actuators.size(); ++i) {
      const double at_home = home.numbers[layout.actuator(static_cast<int>(i))];
      forces[i] = -8e3 * (actuators[i].value - at_home) - 60 * actuators[i].rate + 20 * std::sin(9 * t + static_cast<double>(i));
    }
  };
  p.load = [](double t) { return (Vector6d() << 30 * std::cos(5 * t), 30 * std::sin(5 * t), -20, 0, 2 * t, 1).finished(); };
  p.gravity = {0, 0, -9.81};
  p.start = machine.home();
  p.start_rate = Eigen::VectorXd::Zero(machine.dof());
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  for (int i = 0; i < machine.dof(); ++i) {
    const Coordinate& c = machine.topology().coordinates[static_cast<std::size_t>(i)];
    const double share = 0.02 * (c.box.max - c.box.min);
    p.start(i) += share * symmetric(random);
    p.start_rate(i) = share * symmetric(random);
  }
  for (int i = 0; i < samples; ++i) p.times.push_back(duration * i / (samples - 1));
  return p;
}

}  // namespace

TEST_CASE("inverse dynamics of a motion from forces gives the forces back, between the samples too") {
  for (const char* name : {"gough", "2q-spr", "delta", "p2prpu-prps", "parallel-cross"}) {
    CAPTURE(name);
    const Machine machine = machine_of(name);
    const ForwardProblem p = shaken(machine, 0.3, 16);
    const ForwardMotion motion = forward_dynamics(machine, p);
    INFO(motion.ending);
    REQUIRE(motion.ended > 0.05);
    CHECK(motion.drift_share < 1e-8);
    State state;
    SmallVector q(machine.dof()), rate(machine.dof()), acceleration(machine.dof()), given(machine.dof());
    for (double t = 0; t < motion.ended; t += 0.0137) {
      CAPTURE(t);
      REQUIRE(motion.at(t, q.data(), rate.data(), acceleration.data()));
      // Accelerations by differences of the rates, which the equations of motion never saw: they err by h^2/6 of the rates' third
      // derivative, for oscillations at 300/s and less by some 1e-5, and by the roundings of the rates over h.
      const double h = 2e-5;
      SmallVector before(machine.dof()), after(machine.dof()), unused(machine.dof()), unused_too(machine.dof());
      if (t > h && t + h < motion.ended && motion.at(t - h, unused.data(), before.data(), unused_too.data()) &&
          motion.at(t + h, unused.data(), after.data(), unused_too.data()))
        CHECK(((after - before) / (2 * h) - acceleration).lpNorm<Eigen::Infinity>() < 1e-4 * (1 + acceleration.lpNorm<Eigen::Infinity>()));
      evaluate(machine, q.data(), rate.data(), acceleration.data(), state);
      p.actuator_forces(t, state.actuators, given.data());
      const Loading loading{p.load(t), p.gravity};
      const SmallVector found = virtual_work(machine, state, tangent(machine, state), loading).total();
      CHECK((found - given).lpNorm<Eigen::Infinity>() < 1e-8 * given.lpNorm<Eigen::Infinity>());
    }
  }
}

TEST_CASE("on springs with dampers a platform comes to rest where the springs carry its load") {
  const Machine machine = machine_of("gough");
  ForwardProblem p = shaken(machine, 8, 9);
  const Pose home = machine.home_pose();
  const auto spring = [&](int i, double value) { return -4e4 * (value - home.numbers[machine.layout().actuator(i)]); };
  p.actuator_forces = [&](double, const std::vector<Scalar>& actuators, double* forces) {
    for (int i = 0; i < 6; ++i)
      forces[i] = spring(i, actuators[static_cast<std::size_t>(i)].value) - 1500 * actuators[static_cast<std::size_t>(i)].rate;
  };
  const Vector6d load = (Vector6d() << 50, -20, -100, 3, 1, 2).finished();
  p.load = [&](double) { return load; };
  const ForwardMotion motion = forward_dynamics(machine, p);
  REQUIRE(motion.ending.empty());
  // At rest, by statics over all bodies: no equation of motion, no partials.
  const Eigen::VectorXd q = motion.value.row(8), still = Eigen::VectorXd::Zero(6);
  CHECK(motion.rate.row(8).lpNorm<Eigen::Infinity>() < 1e-7);
  State state;
  evaluate(machine, q.data(), still.data(), still.data(), state);
  Eigen::VectorXd wrenches = weights(machine, state, p.gravity);
  wrenches.segment<6>(6 * machine.topology().platform - 6) += load;
  const Eigen::VectorXd needed = generic_statics(generic_model(machine, state), wrenches).actuator_forces;
  for (int i = 0; i < 6; ++i)
    CHECK(spring(i, state.actuators[static_cast<std::size_t>(i)].value) ==
          Approx(needed(i)).margin(1e-4 * needed.lpNorm<Eigen::Infinity>()));
}

TEST_CASE("without forces, load and gravity a moving platform keeps its kinetic energy") {
  for (const char* name : {"stewart", "5pus-upu", "4sps-spr"}) {
    CAPTURE(name);
    const Machine machine = machine_of(name);
    ForwardProblem p = shaken(machine, 0.5, 11);
    p.actuator_forces = [](double, const std::vector<Scalar>& actuators, double* forces) { std::fill_n(forces, actuators.size(), 0.0); };
    p.load = nullptr;
    p.gravity.setZero();
    const ForwardMotion motion = forward_dynamics(machine, p);
    CHECK(motion.drift_share < 1e-9);
    REQUIRE(motion.energy[0] > 0);
    for (std::size_t i = 0; i < p.times.size() && p.times[i] <= motion.ended; ++i) {
      CHECK(motion.energy[i] == Approx(motion.energy[0]).epsilon(1e-9));
      CHECK(motion.work[i] == 0);
    }
  }
}
