// What the proof along a motion costs: ten seconds in three frequencies, through 40 % of each coordinate's box, of every mechanism.
#include <core/analysis/proof/proof.hpp>
#include <core/host/plugin_file.hpp>
#include <tests/bench/timing.hpp>
#include <tests/proof/sine_motion.hpp>

#include <fmt/core.h>

#include <ctime>

using namespace pmreport;

int main() {
  fmt::print("{:<16} {:>9} {:>10} {:>12} {:>8}  claims that hold, of all; meetings\n", "mechanism", "ms", "intervals", "evaluations",
             "us each");
  for (const char* name : {"gough", "stewart", "parallel-cross", "4sps-spr", "2q-spr", "5pus-upu", "p2prpu-prps", "delta", "par4"}) {
    const auto plugin = host::load_plugin(std::string(PLUGINS "/") + name + ".so");
    const mechanics::Machine machine(*plugin.mechanisms[0], mechanics::default_values(mechanics::describe(*plugin.mechanisms[0])));
    const mechanics::Trajectory motion = test::sine_motion(test::three_frequencies(machine, 0.4, 10), 10, 501);
    analysis::MotionProof proof;
    std::vector<double> times;
    for (int k = 0; k < 7; ++k) {
      const std::clock_t begin = std::clock();
      proof = analysis::prove_motion(machine, motion, {});
      times.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    }
    std::ranges::sort(times);
    long hold = std::ranges::count(proof.claims, analysis::Claim::State::holds, &analysis::Claim::state);
    fmt::print("{:<16} {:>9.2f} {:>10} {:>12} {:>8.2f}  {} of {}; {}{}\n", name, times[times.size() / 2], proof.intervals,
               proof.evaluations, 1e3 * times[times.size() / 2] / static_cast<double>(proof.evaluations), hold, proof.claims.size(),
               proof.meetings.size(), proof.unexamined + (proof.exhausted ? " exhausted" : ""));
  }
}
