// What inverse dynamics with all joint reactions costs here, and in Simbody: see README.md.
#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <tests/bench/timing.hpp>
#include <tests/judges/random_state.hpp>
#include <tests/judges/simbody_model.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>

using namespace pmreport;
using namespace pmreport::mechanics;
using bench::time_calls;
using judges::SimbodyModel;

namespace {

constexpr int states = 1024, rounds = 15;
const Eigen::Vector3d gravity(0, 0, -9.81);

struct Sample {
  std::vector<State> states;
  std::vector<Vector6d> loads;
  std::vector<SimbodyModel::Input> inputs;
  std::vector<double> jets, together;  // of the coordinates: state by state, and as InverseDynamics has them of all states
  std::vector<double> loads_together;
};

Sample sample_of(const Machine& machine, const SimbodyModel& simbody) {
  Sample s;
  std::mt19937_64 random(1);
  const std::size_t count = states, numbers = 3 * static_cast<std::size_t>(machine.dof());
  s.together.resize(numbers * count);
  s.loads_together.resize(6 * count);
  for (std::size_t k = 0; k < count; ++k) {
    s.states.push_back(judges::random_state(machine, random));
    s.loads.push_back(judges::random_loading(random).platform);
    s.inputs.push_back(simbody.input(s.states[k], s.loads[k]));
    for (std::size_t i = 0; i < numbers; ++i) {
      s.jets.push_back(s.states[k].coordinate_jets[i]);
      s.together[i * count + k] = s.jets.back();
    }
    for (std::size_t c = 0; c < 6; ++c) s.loads_together[c * count + k] = s.loads[k](static_cast<Eigen::Index>(c));
  }
  return s;
}

// Who gives other forces is not worth timing.
void require_same(SimbodyModel& simbody, InverseDynamics& ours, const Sample& sample) {
  MotionReactions all;
  ours.solve(states, sample.together.data(), sample.loads_together.data(), gravity, all);
  for (std::size_t k = 0; k < states; ++k) {
    simbody.solve(sample.inputs[k]);
    const std::vector<double> theirs = simbody.actuator_forces();
    double largest = 0, worst = 0;
    for (std::size_t i = 0; i < theirs.size(); ++i) {
      largest = std::max(largest, std::abs(theirs[i]));
      worst = std::max(worst, std::abs(theirs[i] - all.actuator_forces[i * states + k]));
    }
    if (!(worst < 1e-8 * largest)) {
      fmt::print(stderr, "state {}: the actuator forces differ by {}\n", k, worst);
      std::exit(1);
    }
  }
}

// Contenders take turns, a batch each, so that a busy minute of the machine falls on all of them.
struct Contender {
  std::string name;
  std::function<double()> batch;  // [s] a state
  std::size_t peer;               // Simbody for the same task: number of the contender
  std::vector<double> seconds{}, ratios{};
};

void race(std::vector<Contender>& all) {
  for (int round = 0; round < rounds; ++round) {
    for (Contender& c : all) c.seconds.push_back(c.batch());
    for (Contender& c : all) c.ratios.push_back(all[c.peer].seconds.back() / c.seconds.back());
  }
  fmt::print("{:58} {:>10} {:>10} {:>16}\n", "us a state", "median", "fastest", "times as fast");
  for (Contender& c : all) {
    std::ranges::sort(c.seconds);
    std::ranges::sort(c.ratios);
    fmt::print("{:58} {:10.3f} {:10.3f} {:>16.1f}\n", c.name, 1e6 * c.seconds[rounds / 2], 1e6 * c.seconds.front(), c.ratios[rounds / 2]);
  }
  fmt::print("\n");
}

// [s] a call, of one batch.
template <class F>
double once(int calls, F&& f) {
  return time_calls(1, calls, f).median;
}

void run(const std::string& name) {
  const host::PluginFile file = host::load_plugin(std::string(PLUGINS) + "/" + name + ".so");
  const pm_mechanism& mechanism = *file.mechanisms.at(0);
  const Machine machine(mechanism, default_values(describe(mechanism)));
  SimbodyModel simbody(machine);
  simbody.set_gravity(gravity);
  const Sample sample = sample_of(machine, simbody);
  InverseDynamics limbs(machine);
  require_same(simbody, limbs, sample);

  const std::size_t numbers = 3 * static_cast<std::size_t>(machine.dof());
  MotionReactions out;
  State state;
  const JointFrames frames(machine);
  const double length = characteristic_length(machine);

  const auto one_state = [&](bool reactions) {
    return once(4 * states, [&](int k) {
      const auto at = static_cast<std::size_t>(k) % states;
      limbs.solve(1, &sample.jets[numbers * at], sample.loads[at].data(), gravity, out, reactions);
      return out.actuator_forces[0];
    });
  };
  const auto motion = [&](bool reactions) {
    return once(16,
                [&](int) {
                  limbs.solve(states, sample.together.data(), sample.loads_together.data(), gravity, out, reactions);
                  return out.actuator_forces[0];
                }) /
           states;
  };
  const auto placed = [&](int k) -> const State& {
    const State& at = sample.states[static_cast<std::size_t>(k)];
    double q[6], rate[6], acceleration[6];
    for (std::size_t i = 0; i < at.coordinates.size(); ++i) {
      q[i] = at.coordinates[i].value;
      rate[i] = at.coordinates[i].rate;
      acceleration[i] = at.coordinates[i].acceleration;
    }
    evaluate(machine, q, rate, acceleration, state);
    return state;
  };
  const auto loading = [&](int k) { return Loading{sample.loads[static_cast<std::size_t>(k)], gravity}; };

  constexpr std::size_t forces = 0, reactions = 1;
  std::vector<Contender> all{
      {"Simbody, actuator forces",
       [&] {
         return once(states, [&](int k) {
           simbody.solve(sample.inputs[static_cast<std::size_t>(k)]);
           return simbody.actuator_forces()[0];
         });
       },
       forces},
      {"Simbody, and the reactions of its mobilizers",
       [&] {
         return once(states, [&](int k) {
           simbody.solve(sample.inputs[static_cast<std::size_t>(k)]);
           return simbody.actuator_forces()[0] + simbody.mobilizer_reactions();
         });
       },
       reactions},
      {"limb by limb, actuator forces, one state", [&] { return one_state(false); }, forces},
      {"limb by limb, actuator forces, all states", [&] { return motion(false); }, forces},
      {"limb by limb, all reactions with verdicts, one state", [&] { return one_state(true); }, reactions},
      {"limb by limb, all reactions with verdicts, all states", [&] { return motion(true); }, reactions},
      {"virtual work, actuator forces in shares",
       [&] {
         return once(states, [&](int k) {
           const State& at = placed(k);
           return virtual_work(machine, at, tangent(machine, at), loading(k)).inertia(0);
         });
       },
       forces},
      {"over all bodies, all reactions with verdicts",
       [&] {
         return once(states / 32, [&](int k) {
           const State& at = placed(k);
           return dense_reactions(machine, at, generic_model(machine, at), frames, loading(k), length).actuator_forces(0);
         });
       },
       reactions}};
  fmt::print("{} through its plugin{}, {} states, {} rounds; Simbody with {} constraint equations\n\n", name,
             file.level.empty() ? "" : " for " + file.level, states, rounds, simbody.constraint_equations());
  race(all);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    for (int i = 1; i < argc; ++i) run(argv[i]);
    if (argc == 1) run("gough");
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
