// Inverse dynamics of Gough's platform, here and by MuJoCo, in the same run: see README.md.
#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <tests/bench/timing.hpp>
#include <tests/judges/mujoco_model.hpp>

#include <Eigen/LU>

#include <array>
#include <numbers>
#include <random>
#include <stdexcept>

using namespace pmreport;
using namespace pmreport::mechanics;
using bench::time_calls;
using bench::Timing;

namespace {

// Short batches, so that most of them run undisturbed.
constexpr int states = 1024, batch = 64, repetitions = 32 * states / batch, dof = 6;

// A heavier platform and legs than the plugin's defaults, in the size of a bench-top hexapod.
ParameterValues parameters(const MechanismInfo& info) {
  ParameterValues values = default_values(info);
  const auto set = [&](const char* name, std::vector<double> value) {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (info.parameters[i].name == name) values[i] = std::move(value);
  };
  const auto circle = [](double radius, const std::array<double, 6>& azimuths) {
    std::vector<double> points;
    for (const double azimuth : azimuths) {
      const double angle = azimuth * std::numbers::pi / 180;
      points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    return points;
  };
  set("base_points", circle(0.3, {15, 105, 135, 225, 255, 345}));
  set("platform_points", circle(0.2, {45, 75, 165, 195, 285, 315}));
  set("home_position", {0, 0, 0.8});
  set("platform_radius", {std::sqrt(0.07)}), set("platform_thickness", {std::sqrt(0.03)});  // a disc of 10 kg: 0.2, 0.2, 0.35 kg m^2
  set("cylinder_mass", {5}), set("cylinder_length", {0.4}), set("cylinder_radius", {std::sqrt(2 * 0.002 / 5)});  // axial 0.002 kg m^2
  set("rod_mass", {3}), set("rod_length", {0.4}), set("rod_radius", {std::sqrt(2 * 0.002 / 3)});
  return values;
}

struct Motion {
  std::array<double, dof> q, rate, acceleration;
};

std::vector<Motion> random_motions(const Machine& machine) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  const Eigen::VectorXd home = machine.home();
  std::vector<Motion> out(states);
  for (Motion& m : out)
    for (std::size_t i = 0; i < dof; ++i) {
      m.q[i] = home(static_cast<Eigen::Index>(i)) + (i < 3 ? 0.08 : 0.3) * symmetric(random);
      m.rate[i] = (i < 3 ? 0.5 : 1) * symmetric(random);
      m.acceleration[i] = (i < 3 ? 3 : 5) * symmetric(random);
    }
  return out;
}

// MuJoCo's forces, its loops solved as fast as can be: one leg carries the platform, five are pinned to it. The 15 freedoms that are not
// driven give the 15 forces of the pins, and these the rest.
class LoopSolve {
 public:
  static constexpr int passive = 15;

  explicit LoopSolve(judges::MujocoModel& model) : model_(model) {
    for (int i = 0; i < model.freedoms(); ++i)
      if (std::ranges::find(model.driven(), i) == model.driven().end()) passive_.push_back(i);
    if (passive_.size() != passive) throw std::runtime_error("MuJoCo's tree has other freedoms than expected");
  }
  Vector6d operator()(const judges::JointMotion& motion, const Loading& loading) {
    const auto needed = model_.needed(motion, loading);
    const auto jacobian = model_.pin_jacobian();
    Eigen::Matrix<double, passive, passive> system;
    Eigen::Matrix<double, passive, 1> right;
    for (int i = 0; i < passive; ++i) {
      const int at = passive_[static_cast<std::size_t>(i)];
      system.row(i) = jacobian.col(at).head<passive>().transpose();
      right(i) = needed(at);
    }
    const Eigen::Matrix<double, passive, 1> pins = system.partialPivLu().solve(right);
    Vector6d forces;
    for (int i = 0; i < dof; ++i) {
      const int at = model_.driven()[static_cast<std::size_t>(i)];
      forces(i) = needed(at) - jacobian.col(at).head<passive>().dot(pins);
    }
    return forces;
  }

 private:
  judges::MujocoModel& model_;
  std::vector<int> passive_;
};

void print(const char* what, const Timing& t, const Timing& peer) {
  fmt::print("{:58} {:8.3f} {:8.3f} {:8.1f}\n", what, 1e6 * t.median, 1e6 * t.fastest, peer.median / t.median);
}

void run(const Machine& machine) {
  const Loading loading{Vector6d::Zero(), {0, 0, -9.81}};
  const std::vector<Motion> motions = random_motions(machine);
  judges::MujocoModel model(machine);
  LoopSolve loop_solve(model);
  std::size_t next = 0;  // goes round all states, batch after batch
  const auto turn = [&] { return next = (next + 1) % states; };

  State state;
  Tangent along;
  const auto by_work = [&](const Motion& m) -> SmallVector {
    evaluate(machine, m.q.data(), m.rate.data(), m.acceleration.data(), state);
    tangent(machine, state, along);
    return virtual_work(machine, state, along, loading).total();
  };
  InverseDynamics dynamics(machine);
  MotionReactions reactions;
  const double no_load[6] = {};
  double jets[3 * dof];
  const auto one = [&](const Motion& m, bool all) {
    for (std::size_t i = 0; i < dof; ++i) jets[3 * i] = m.q[i], jets[3 * i + 1] = m.rate[i], jets[3 * i + 2] = m.acceleration[i];
    dynamics.solve(1, jets, no_load, loading.gravity, reactions, all);
    return Vector6d(reactions.actuator_forces.data());
  };

  // The programs must agree, or their times mean nothing. MuJoCo is handed the motion of its joints, made outside of what is timed.
  std::vector<judges::JointMotion> joint_motions;
  double largest = 0, worst = 0;
  for (const Motion& m : motions) {
    const SmallVector ours = by_work(m);
    joint_motions.push_back(model.joint_motion(state));
    const Vector6d theirs = loop_solve(joint_motions.back(), loading);
    largest = std::max(largest, theirs.lpNorm<Eigen::Infinity>());
    worst = std::max({worst, (ours - theirs).lpNorm<Eigen::Infinity>(), (one(m, false) - theirs).lpNorm<Eigen::Infinity>()});
  }
  fmt::print("{} states, actuator forces to {:.0f} N, programs within {:.1e} N of one another\n\n", states, largest, worst);
  if (!(worst < 1e-8 * largest)) throw std::runtime_error("the programs do not agree");

  std::vector<double> many(3 * dof * states), many_loads(6 * states);
  for (std::size_t k = 0; k < states; ++k)
    for (std::size_t i = 0; i < dof; ++i) {
      many[(3 * i) * states + k] = motions[k].q[i];
      many[(3 * i + 1) * states + k] = motions[k].rate[i];
      many[(3 * i + 2) * states + k] = motions[k].acceleration[i];
    }
  const auto all_at_once = [&](bool all) {
    Timing t = time_calls(repetitions, 1, [&](int) {
      dynamics.solve(states, many.data(), many_loads.data(), loading.gravity, reactions, all);
      return reactions.actuator_forces.back();
    });
    return Timing{t.fastest / states, t.median / states};
  };

  const Timing peer = time_calls(repetitions, batch, [&](int) { return loop_solve(joint_motions[turn()], loading)(0); });
  fmt::print("{:58} {:>8} {:>8} {:>8}\n", "us a state", "median", "fastest", "times");
  print("MuJoCo: mj_inverse alone, loops not solved",
        time_calls(repetitions, batch, [&](int) { return model.needed(joint_motions[turn()], loading)(0); }), peer);
  print("MuJoCo: mj_inverse and exact solve of the loops", peer, peer);
  print("motion, tangent, virtual work", time_calls(repetitions, batch, [&](int) { return by_work(motions[turn()])(0); }), peer);
  print("InverseDynamics, one state at a time, forces", time_calls(repetitions, batch, [&](int) { return one(motions[turn()], false)(0); }),
        peer);
  print("InverseDynamics, one state at a time, forces and reactions",
        time_calls(repetitions, batch, [&](int) { return one(motions[turn()], true)(0); }), peer);
  print("InverseDynamics, all states at once, forces", all_at_once(false), peer);
  print("InverseDynamics, all states at once, forces and reactions", all_at_once(true), peer);
}

}  // namespace

int main() {
  try {
    const host::PluginFile file = host::load_plugin(PLUGINS "/gough.so");
    const pm_mechanism& mechanism = *file.mechanisms.at(0);
    run(Machine(mechanism, parameters(describe(mechanism))));
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
