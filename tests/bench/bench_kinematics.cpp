// What the steps of an analysis cost, for the 4SPS-SPR through its plugin: see README.md.
#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/conformance/properties.hpp>
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <tests/bench/hand_written.hpp>
#include <tests/bench/timing.hpp>

#include <cstdlib>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using bench::time_calls;
using bench::Timing;

namespace {

constexpr int poses = 1024, dof = 5, repetitions = 25;

struct Sample {
  std::vector<double> q;      // pose by pose
  std::vector<double> guess;  // a centimetre away
  const double* at(int k) const { return &q[static_cast<std::size_t>(k % poses * dof)]; }
};

Sample sample_of(const Machine& machine) {
  Sample s;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  for (std::size_t k = 0; k < poses; ++k) {
    Eigen::Matrix<double, dof, 1> away;
    for (std::size_t i = 0; i < dof; ++i) {
      const Range& box = machine.topology().coordinates[i].box;
      s.q.push_back(std::uniform_real_distribution(box.min, box.max)(random));
      away(static_cast<int>(i)) = symmetric(random);
    }
    away *= 0.01 / away.norm();
    for (std::size_t i = 0; i < dof; ++i) s.guess.push_back(s.q[k * dof + i] + away(static_cast<int>(i)));
  }
  return s;
}

void print(const char* what, const Timing& t, double target = 0, double floor = 0) {
  fmt::print("{:44} {:10.3f} {:10.3f}", what, 1e6 * t.median, 1e6 * t.fastest);
  fmt::print("{:>10}", target > 0 ? fmt::format("{:.1f}", 1e6 * target) : "");
  fmt::print("{:>10}\n", floor > 0 ? fmt::format("{:.1f}", t.median / floor) : "");
}

// The hand-written floor must be the same mechanism, or the ratio means nothing.
void require_same(const Machine& machine, const bench::HandWritten& by_hand, const Sample& sample) {
  double length[5];
  bench::HandWritten::Point direction[5];
  std::vector<double> placement(machine.layout().size());
  for (int k = 0; k < poses; ++k) {
    by_hand(sample.at(k), length, direction);
    machine.place(PM_VALUE, 1, sample.at(k), placement.data());
    for (int i = 0; i < dof; ++i)
      if (!(std::abs(length[i] - placement[machine.layout().actuator(i)]) < 1e-12)) {
        fmt::print(stderr, "limb {} of pose {}: {} by hand, {} by the plugin\n", i + 1, k, length[i],
                   placement[machine.layout().actuator(i)]);
        std::exit(1);
      }
  }
}

void run(const Machine& machine) {
  const Sample sample = sample_of(machine);
  const bench::HandWritten by_hand;
  require_same(machine, by_hand, sample);

  fmt::print("{} through its plugin, {} poses, {} batches\n\n", machine.info().name, poses, repetitions);
  fmt::print("{:44} {:>10} {:>10}{:>10}{:>10}\n", "us a call", "median", "fastest", "target", "ratio");

  double length[5];
  bench::HandWritten::Point direction[5];
  const Timing floor =
      time_calls(repetitions, 64 * poses, [&](int k) { return by_hand(sample.at(k), length, direction) + length[4] + direction[4].x; });
  print("inverse displacement written by hand", floor, 0, floor.median);

  std::vector<double> placement(machine.layout().size());
  print("place, one pose",
        time_calls(repetitions, 64 * poses,
                   [&](int k) {
                     machine.place(PM_VALUE, 1, sample.at(k), placement.data());
                     return placement.back();
                   }),
        0.3e-6, floor.median);

  for (const std::size_t batch : {std::size_t{60}, std::size_t{poses}}) {
    std::vector<double> many(machine.layout().size() * batch), many_q(dof * batch);
    for (std::size_t i = 0; i < dof; ++i)
      for (std::size_t k = 0; k < batch; ++k) many_q[i * batch + k] = sample.q[k * dof + i];
    Timing lanes = time_calls(repetitions, static_cast<int>(16 * poses / batch), [&](int) {
      machine.place(PM_VALUE, batch, many_q.data(), many.data());
      return many.back();
    });
    lanes = {lanes.fastest / static_cast<double>(batch), lanes.median / static_cast<double>(batch)};
    print(fmt::format("place, {} poses at once, each", batch).c_str(), lanes, 0, floor.median);
  }

  const double rate[dof] = {0.1, -0.2, 0.3, 0.2, -0.1}, acceleration[dof] = {1, 0.5, -2, 1, 3};
  std::vector<double> jets(3 * machine.layout().size()), jet_q(3 * dof);
  print("place, jets: rates and accelerations",
        time_calls(repetitions, 16 * poses,
                   [&](int k) {
                     for (std::size_t i = 0; i < dof; ++i) {
                       jet_q[3 * i] = sample.at(k)[i];
                       jet_q[3 * i + 1] = rate[i];
                       jet_q[3 * i + 2] = acceleration[i];
                     }
                     machine.place(PM_JET, 1, jet_q.data(), jets.data());
                     return jets.back();
                   }),
        0, floor.median);
  State state;
  print("all body motions by jets (evaluate)",
        time_calls(repetitions, 16 * poses,
                   [&](int k) {
                     evaluate(machine, sample.at(k), rate, acceleration, state);
                     return state.bodies.back().angular_acceleration.x();
                   }),
        2e-6, floor.median);

  std::vector<double> partials(machine.components(PM_PARTIALS) * machine.layout().size());
  print("place, partials",
        time_calls(repetitions, 16 * poses,
                   [&](int k) {
                     machine.place(PM_PARTIALS, 1, sample.at(k), partials.data());
                     return partials.back();
                   }),
        0, floor.median);

  double g[36];
  print("jacobian of a placement", time_calls(repetitions, 64 * poses, [&](int) {
          machine.jacobian(PM_VALUE, 1, placement.data(), g);
          return g[35];
        }));
  const double size = characteristic_length(machine);
  print("closed form: G, its rate, its condition",
        time_calls(repetitions, 4 * poses, [&](int) { return closed_form(machine, state, size).condition; }));

  std::vector<SmallVector> targets, guesses;
  for (int k = 0; k < poses; ++k) {
    machine.place(PM_VALUE, 1, sample.at(k), placement.data());
    targets.push_back(Eigen::Map<const Eigen::VectorXd>(&placement[machine.layout().actuator(0)], dof));
    guesses.push_back(Eigen::Map<const Eigen::VectorXd>(&sample.guess[static_cast<std::size_t>(k * dof)], dof));
  }
  ForwardSolver solver(machine);
  int converged = 0, iterations = 0;
  for (std::size_t k = 0; k < poses; ++k) {
    const ForwardSolution s = solver.solve(targets[k], guesses[k]);
    converged += s.outcome == Outcome::good;
    iterations += s.iterations;
  }
  print("forward displacement, guess 1 cm away",
        time_calls(repetitions, 4 * poses,
                   [&](int k) {
                     const auto i = static_cast<std::size_t>(k % poses);
                     return solver.solve(targets[i], guesses[i]).coordinates(0);
                   }),
        5e-6, floor.median);
  print("generic model: constraints, bias, actuation",
        time_calls(repetitions, poses, [&](int) { return generic_model(machine, state).bias(0); }));
  const GenericModel model = generic_model(machine, state);
  const Vector6d load = Vector6d::Ones();
  print("generic statics", time_calls(repetitions, 8, [&](int) { return generic_statics(machine, model, load).residual; }));
  print("mobility by rank", time_calls(repetitions, 8, [&](int) { return double(mobility(machine, state).rank); }));
  print("properties, 100 poses", time_calls(5, 1, [&](int) { return check_properties(machine, {100, 1})[0].worst; }));
  fmt::print("\nforward displacement: {} of {} converged, {:.1f} placements each\n", converged, poses, double(iterations) / poses);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const host::PluginFile file = host::load_plugin(argc > 1 ? argv[1] : PLUGINS "/4sps-spr.so");
    const pm_mechanism& mechanism = *file.mechanisms.at(0);
    run(Machine(mechanism, default_values(describe(mechanism))));
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
