// Inverse dynamics and reactions of every mechanism before MuJoCo, which knows its bodies, its joints and how it stands at home.
#include <core/host/plugin_file.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/reactions.hpp>
#include <tests/judges/mujoco_model.hpp>
#include <tests/judges/random_state.hpp>

#include <catch2/catch.hpp>

#include <filesystem>

using namespace pmreport;
using namespace pmreport::mechanics;
using judges::MujocoModel;

namespace {

constexpr int states = 32;
constexpr double place_tolerance = 1e-9;  // [m], [m/s], [m/s^2], radians likewise: chains of up to ten joints, each known to a rounding
constexpr double force_tolerance = 1e-8;  // of the largest: promised; poses near a singular one magnify the roundings of both sides

// Calls f(machine, MuJoCo's model, random numbers) for every mechanism, default parameters, in a section of its own.
template <class F>
void each_mechanism(F&& f) {
  for (const char* name : {"gough", "stewart", "parallel-cross", "delta", "4sps-spr", "5pus-upu", "2q-spr", "p2prpu-prps", "par4"})
    DYNAMIC_SECTION(name) {
      const host::PluginFile file = host::load_plugin(std::filesystem::path(PLUGINS) / (std::string(name) + ".so"));
      const pm_mechanism& table = *file.mechanisms.at(0);
      const Machine machine(table, default_values(describe(table)));
      MujocoModel model(machine);
      std::mt19937_64 random(20);
      for (int k = 0; k < states; ++k) {
        CAPTURE(name, k);
        const State state = judges::random_state(machine, random);
        REQUIRE(state.status == PM_OK);
        f(machine, model, state, judges::random_loading(random));
      }
    }
}

double largest(const Eigen::MatrixXd& m) { return m.size() == 0 ? 0 : m.lpNorm<Eigen::Infinity>(); }

}  // namespace

TEST_CASE("MuJoCo finds every body where we place it, as fast, and accelerating as much") {
  each_mechanism([](const Machine& machine, MujocoModel& model, const State& state, const Loading& loading) {
    model.needed(model.joint_motion(state), loading);
    for (std::size_t i = 1; i < state.bodies.size(); ++i) {
      CAPTURE(machine.topology().bodies[i].name);
      const BodyState seen = model.body(static_cast<int>(i));
      CHECK(largest(seen.origin - state.bodies[i].origin) <= place_tolerance);
      CHECK(largest(seen.rotation - state.bodies[i].rotation) <= place_tolerance);
      CHECK(largest(seen.twist() - state.bodies[i].twist()) <= place_tolerance * (1 + largest(seen.twist())));
      CHECK(largest(seen.twist_rate() - state.bodies[i].twist_rate()) <= place_tolerance * (1 + largest(seen.twist_rate())));
    }
  });
}

TEST_CASE("in MuJoCo the loops are closed, and stay so") {
  each_mechanism([](const Machine&, MujocoModel& model, const State& state, const Loading& loading) {
    const judges::JointMotion motion = model.joint_motion(state);
    model.needed(motion, loading);
    REQUIRE(model.pin_jacobian().rows() > 0);
    CHECK(largest(model.pin_gaps()) <= place_tolerance);
    const Eigen::VectorXd opening = model.pin_jacobian() * motion.velocity;
    CHECK(largest(opening) <= place_tolerance * (1 + largest(motion.velocity)));
  });
}

TEST_CASE("MuJoCo's actuator forces are those of virtual work and of the system over all bodies") {
  each_mechanism([](const Machine& machine, MujocoModel& model, const State& state, const Loading& loading) {
    const MujocoModel::Solution judged = model.solve(state, loading);
    CHECK(judged.residual <= force_tolerance);
    const double scale = largest(judged.actuators);
    const Eigen::VectorXd by_work = virtual_work(machine, state, tangent(machine, state), loading).total();
    CHECK(largest(by_work - judged.actuators) <= force_tolerance * scale);
    const JointReactions reactions =
        dense_reactions(machine, state, generic_model(machine, state), JointFrames(machine), loading, characteristic_length(machine));
    REQUIRE_FALSE(reactions.singular);
    CHECK(largest(reactions.actuator_forces - judged.actuators) <= force_tolerance * scale);
  });
}

TEST_CASE("MuJoCo's wrench in every joint is our reaction, wherever there is but one") {
  each_mechanism([](const Machine& machine, MujocoModel& model, const State& state, const Loading& loading) {
    const double length = characteristic_length(machine);
    const MujocoModel::Solution judged = model.solve(state, loading);
    const JointReactions reactions = dense_reactions(machine, state, generic_model(machine, state), JointFrames(machine), loading, length);
    double scale = 0;
    for (const Vector6d& w : judged.joints) scale = std::max({scale, largest(w.head<3>()), largest(w.tail<3>()) / length});
    int unique = 0;
    for (std::size_t j = 0; j < judged.joints.size(); ++j)
      for (int c = 0; c < 6; ++c) {
        if ((reactions.indeterminate[j] & (64 << c)) != 0) continue;
        CAPTURE(machine.topology().joints[j].name, c, judged.joints[j].transpose(), reactions.joints[j].transpose());
        CHECK(std::abs(judged.joints[j](c) - reactions.joints[j](c)) <= force_tolerance * scale * (c < 3 ? 1 : length));
        ++unique;
      }
    CHECK(unique > 0);
    if (reactions.stresses.empty()) CHECK(unique == static_cast<int>(6 * judged.joints.size()));
  });
}
