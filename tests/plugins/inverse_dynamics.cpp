// Forces and reactions limb by limb are those of the system over all bodies, for every mechanism there is.

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/reactions/by_limb/planner.hpp>
#include <tests/mechanics/motions.hpp>
#include <tests/plugins/hexapods.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

struct Overconstrained {
  const char* plugin;
  int stresses;  // as the sources count redundant constraints
};
constexpr Overconstrained all[] = {{"4sps-spr", 0}, {"2q-spr", 6},  {"5pus-upu", 0},       {"p2prpu-prps", 2},
                                   {"gough", 0},    {"stewart", 0}, {"parallel-cross", 0}, {"delta", 0}};

Machine machine_of(const pm_mechanism& table) { return Machine(table, default_values(describe(table))); }

}  // namespace

TEST_CASE("limb by limb, forces, reactions and verdicts are those of the system over all bodies") {
  for (const Overconstrained& e : all) DYNAMIC_SECTION(e.plugin) {
      const Machine machine = machine_of(test::plugin(e.plugin));
      const auto plan = plan_of(machine);
      REQUIRE(plan.has_value());
      CHECK(plan->stresses() == e.stresses);
      test::require_same_as_dense(machine, 100, 11);
    }
}

TEST_CASE("limb by limb agrees with all bodies at once whatever a mechanism is told to choose") {
  for (const Overconstrained& e : all) {
    const pm_mechanism& table = test::plugin(e.plugin);
    const MechanismInfo info = describe(table);
    for (std::size_t i = 0; i < info.parameters.size(); ++i)
      for (std::size_t choice = 0; choice < info.parameters[i].choices.size(); ++choice) {
        const double given = static_cast<double>(choice);
        if (given == info.parameters[i].defaults[0]) continue;  // the case before
        ParameterValues values = default_values(info);
        values[i] = {given};
        std::optional<Machine> machine;
        try {
          machine.emplace(table, values);
        } catch (const MechanismError&) {  // a choice that the other parameters rule out
          continue;
        }
        DYNAMIC_SECTION(info.name << " with " << info.parameters[i].name << " = " << info.parameters[i].choices[choice]) {
          CHECK(plan_of(*machine).has_value());
          test::require_same_as_dense(*machine, 20, 12);
        }
      }
  }
}

TEST_CASE("actuator forces are those of virtual work, which knows no joint") {
  for (const Overconstrained& e : all) DYNAMIC_SECTION(e.plugin) {
      const Machine machine = machine_of(test::plugin(e.plugin));
      const test::LoadedMotion motion = test::random_loaded_motion(machine, 50, 13);
      InverseDynamics dynamics(machine);
      const MotionReactions seen = test::solve(dynamics, motion, false);
      double worst = 0;
      for (std::size_t k = 0; k < motion.count; ++k) {
        const State state = motion.state(machine, k);
        const SmallVector expected = virtual_work(machine, state, tangent(machine, state), motion.loading(k)).total();
        for (std::size_t i = 0; i < motion.dof; ++i) {
          const double off = std::abs(seen.actuator_forces[i * motion.count + k] - expected(static_cast<int>(i)));
          if (!(off <= worst)) worst = off / expected.lpNorm<Eigen::Infinity>();
        }
      }
      CHECK(worst < test::agreement);
    }
}

TEST_CASE("a singular pose has no forces and leaves its neighbours alone") {
  const auto machine = test::hexapod("gough");
  test::LoadedMotion motion = test::random_loaded_motion(*machine, 20, 14);
  InverseDynamics dynamics(*machine);
  const MotionReactions before = test::solve(dynamics, motion);
  constexpr std::size_t singular = 5;
  Eigen::VectorXd q = machine->home();
  q(3) = test::singular_yaw(*machine, 80, 95) * deg;  // 90 degrees: Fichter's singularity
  for (std::size_t i = 0; i < 6; ++i) motion.jets[3 * i * motion.count + singular] = q(static_cast<int>(i));
  const MotionReactions after = test::solve(dynamics, motion);
  CHECK(after.regularity[singular] < 1e-9);
  for (const auto& [was, is] : {std::pair{&before.actuator_forces, &after.actuator_forces}, std::pair{&before.joints, &after.joints}})
    for (std::size_t i = 0; i < was->size(); ++i) {
      if (i % motion.count == singular)
        CHECK(std::isnan((*is)[i]));
      else
        CHECK((*is)[i] == (*was)[i]);
    }
}
