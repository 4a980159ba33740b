// What inverse dynamics and joint reactions cost, for every mechanism through its plugin: see README.md.
#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/reactions/by_limb/kernel.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <tests/bench/timing.hpp>

#include <random>
#include <string>

using namespace pmreport;
using namespace pmreport::mechanics;
using bench::time_calls;

namespace {

constexpr std::size_t poses = 1024;
constexpr std::size_t motion_samples = 10001;  // 10 s at 1 kHz
const Eigen::Vector3d gravity(0, 0, -9.81);

// Random states in the box of the coordinates, rates to 1 and accelerations to 5 a second (squared), loads to 100 N and 100 N m.
struct States {
  std::vector<double> jets, loads;          // pose by pose
  std::vector<double> all_jets, all_loads;  // as the contract lays out all of them
};

States states_of(const Machine& machine, std::size_t count) {
  const auto dof = static_cast<std::size_t>(machine.dof());
  const std::vector<Eigen::VectorXd> q = random_poses(machine, static_cast<int>(poses), 1);
  if (q.empty()) throw std::runtime_error("no pose of " + machine.info().name + " can be assembled");
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  States s;
  s.all_jets.resize(3 * dof * count);
  s.all_loads.resize(6 * count);
  for (std::size_t k = 0; k < count; ++k) {
    for (std::size_t i = 0; i < dof; ++i) {
      const double numbers[3] = {q[k % q.size()](static_cast<int>(i)), symmetric(random), 5 * symmetric(random)};
      for (std::size_t c = 0; c < 3; ++c) {
        s.jets.push_back(numbers[c]);
        s.all_jets[(3 * i + c) * count + k] = numbers[c];
      }
    }
    for (std::size_t c = 0; c < 6; ++c) {
      s.loads.push_back(100 * symmetric(random));
      s.all_loads[c * count + k] = s.loads.back();
    }
  }
  return s;
}

double microseconds(const bench::Timing& t, std::size_t share = 1) { return 1e6 * t.median / static_cast<double>(share); }

void run(const Machine& machine) {
  const States s = states_of(machine, poses);
  const auto dof = static_cast<std::size_t>(machine.dof());
  InverseDynamics dynamics(machine);
  MotionReactions out;
  const auto jets = [&](int k) { return &s.jets[static_cast<std::size_t>(k) * 3 * dof]; };
  const auto load = [&](int k) { return &s.loads[static_cast<std::size_t>(k) * 6]; };
  // Short batches, of which most fall between the time slices of neighbours; the states take turns.
  constexpr int repetitions = 200, calls = 128;
  int turn = 0;
  const auto next = [&] { return turn = (turn + 1) % static_cast<int>(poses); };

  const auto single = [&](bool reactions) {
    return microseconds(time_calls(repetitions, calls, [&](int) {
      const int k = next();
      dynamics.solve(1, jets(k), load(k), gravity, out, reactions);
      return out.actuator_forces[0];
    }));
  };
  const auto lanes = [&](bool reactions) {
    return microseconds(time_calls(repetitions, 1,
                                   [&](int) {
                                     dynamics.solve(poses, s.all_jets.data(), s.all_loads.data(), gravity, out, reactions);
                                     return out.actuator_forces[0];
                                   }),
                        poses);
  };
  std::vector<double> placement(3 * machine.layout().size() * 16), together(3 * dof * 16);
  for (std::size_t i = 0; i < 3 * dof; ++i) std::copy_n(&s.all_jets[i * poses], 16, &together[16 * i]);
  const double place_single = microseconds(time_calls(repetitions, calls, [&](int) {
    machine.place(PM_JET, 1, jets(next()), placement.data());
    return placement[1];
  }));
  const double place_lanes = microseconds(time_calls(repetitions, calls / 16,
                                                     [&](int) {
                                                       machine.place(PM_JET, 16, together.data(), placement.data());
                                                       return placement[1];
                                                     }),
                                          16);

  // What the general ways cost, a state at a time.
  const JointFrames frames(machine);
  const double length = characteristic_length(machine);
  State state;
  const auto evaluated = [&](int k) -> const State& {
    Eigen::VectorXd q[3];
    for (int c = 0; c < 3; ++c) q[c] = Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<3>>(jets(k) + c, machine.dof());
    evaluate(machine, q[0].data(), q[1].data(), q[2].data(), state);
    return state;
  };
  const auto loading = [&](int k) { return Loading{Eigen::Map<const Vector6d>(load(k)), gravity}; };
  const double by_work = microseconds(time_calls(repetitions, calls, [&](int) {
    const int k = next();
    const State& at = evaluated(k);
    return virtual_work(machine, at, tangent(machine, at), loading(k)).total()(0);
  }));
  const double dense = microseconds(time_calls(25, 4, [&](int) {
    const int k = next();
    const State& at = evaluated(k);
    return dense_reactions(machine, at, generic_model(machine, at), frames, loading(k), length).residual;
  }));

  const States motion = states_of(machine, motion_samples);
  const bench::Timing whole = time_calls(5, 1, [&](int) {
    dynamics.solve(motion_samples, motion.all_jets.data(), motion.all_loads.data(), gravity, out);
    return out.actuator_forces[0];
  });
  fmt::print("{:16}{:9.2f}{:9.2f}{:9.2f}  {:9.2f}{:9.2f}{:9.2f}  {:11.2f}{:11.0f}{:11.1f}\n", machine.info().name, place_single,
             single(false), single(true), place_lanes, lanes(false), lanes(true), by_work, dense, 1e3 * whole.median);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    fmt::print("{} random states, {} lanes; medians, microseconds a state, placement included; a motion of {} samples in ms\n\n", poses,
               DynamicsKernel::widest().width(), motion_samples);
    fmt::print("{:16}{:^27}  {:^27}  {:^22}{:>11}\n", "", "one state at a time", "in lanes", "over all bodies", "motion");
    fmt::print("{:16}{:>9}{:>9}{:>9}  {:>9}{:>9}{:>9}  {:>11}{:>11}{:>11}\n", "", "place", "forces", "all", "place", "forces", "all",
               "work", "dense", "all");
    std::vector<std::string> files(argv + 1, argv + argc);
    if (files.empty())
      for (const char* name : {"gough", "stewart", "parallel-cross", "4sps-spr", "2q-spr", "5pus-upu", "p2prpu-prps", "delta"})
        files.push_back(fmt::format("{}/{}.so", PLUGINS, name));
    for (const std::string& file : files)
      for (const pm_mechanism* mechanism : host::load_plugin(file).mechanisms)
        run(Machine(*mechanism, default_values(describe(*mechanism))));
    fmt::print("{:16}{:>9}{:>9}{:>9}  {:>9}{:>9}{:>9}  {:>11}{:>11}{:>11}\n", "targets (gough)", "", "3", "10", "", "0.5", "10", "", "",
               "1000");
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
