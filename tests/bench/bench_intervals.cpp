// What a box of poses costs beside a pose, and beside other interval libraries: see README.md.
#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/model/machine.hpp>
#include <core/program/boxes.hpp>
#include <tests/bench/interval_kernel.hpp>
#include <tests/bench/timing.hpp>

#include <cmath>
#include <numeric>
#include <random>

using namespace pmreport;
using namespace pmreport::bench;

namespace {

constexpr std::size_t boxes = 1024;
constexpr int rounds = 25;

struct Entry {
  const char* name;
  Contender run;
  int calls;  // a round
  std::vector<double> nanoseconds = {};
};

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return x[x.size() / 2];
}

// The contenders take turns, a batch each in every round.
void hexapod_margins() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> within(-0.2, 0.2);
  std::vector<PositionBox> sample(boxes);
  for (PositionBox& b : sample) b = {{within(random), within(random), 0.8 + within(random)}, 0.005};
  const Hexapod hexapod;

  std::vector<Entry> entries{
      {"one pose, plain numbers", in_plain_numbers, 40},
      {"one pose of many in lanes", in_plain_lanes, 100},
      {"Interval", in_intervals, 10},
      {"IntervalLanes", in_interval_lanes, 40},
      {"to nearest, ends moved by a neighbour", in_widened, 10},
      {"the same in lanes", in_widened_lanes, 40},
      {"FLINT/Arb, 53 bits", by_arb, 1},
      {"MPFI, 53 bits", by_mpfi, 1},
      {"Boost.Interval, default policies", by_boost, 1},
      {"Boost.Interval, mode saved", by_boost_saving_the_mode, 1},
  };
  const double truth = by_mpfi(hexapod, sample);
  for (const Entry& e : entries)
    if (const double sum = e.run(hexapod, sample); e.run != in_plain_numbers && e.run != in_plain_lanes &&
                                                   !(std::abs(sum - truth) < (e.run == by_arb ? 0.05 : 1e-9) * std::abs(truth)))
      throw std::runtime_error(fmt::format("{}: {}, MPFI has {}", e.name, sum, truth));

  for (int round = 0; round <= rounds; ++round)
    for (Entry& e : entries) {
      const Timing t = time_calls(1, e.calls, [&](int) { return e.run(hexapod, sample); });
      if (round > 0) e.nanoseconds.push_back(1e9 * t.median / boxes);
    }
  const auto ratio = [&](const Entry& of, const Entry& to) {
    std::vector<double> all;
    for (std::size_t i = 0; i < of.nanoseconds.size(); ++i) all.push_back(of.nanoseconds[i] / to.nanoseconds[i]);
    return median(all);
  };
  fmt::print("strokes and cones of a hexapod, {} boxes, {} rounds; medians\n\n{:40}{:>10}{:>14}{:>14}\n", boxes, rounds, "", "ns a box",
             "by a pose", "Arb by it");
  for (const Entry& e : entries)
    fmt::print("{:40}{:10.1f}{:14.2f}{:14.1f}\n", e.name, median(e.nanoseconds), ratio(e, entries[0]), ratio(entries[6], e));
}

void recorded_programs(const char* file) {
  const host::PluginFile plugin = host::load_plugin(file);
  const mechanics::Machine machine(*plugin.mechanisms.at(0), mechanics::default_values(mechanics::describe(*plugin.mechanisms.at(0))));
  const program::Program* whole = machine.program();
  if (whole == nullptr) throw std::runtime_error("it records no program");

  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.3, 0.7);
  const std::size_t dof = static_cast<std::size_t>(machine.dof());
  std::vector<program::Bounds> in(dof * boxes);
  std::vector<double> at(dof * boxes);
  for (std::size_t i = 0; i < dof; ++i)
    for (std::size_t k = 0; k < boxes; ++k) {
      const Range& box = machine.topology().coordinates[i].box;
      const double low = box.min + share(random) * (box.max - box.min);
      in[i * boxes + k] = {low, low + 1e-3 * (box.max - box.min)};
      at[i * boxes + k] = low;
    }
  const auto time_boxes = [&](const program::Program& p) {
    program::Boxes runner(p);
    std::vector<program::Bounds> out(p.outputs().size() * boxes);
    return 1e9 *
           time_calls(rounds, 8,
                      [&](int) {
                        runner.run(boxes, in.data(), out.data());
                        return out.back().high;
                      })
               .median /
           boxes;
  };
  const auto time_place = [&](std::size_t batch) {
    std::vector<double> placement(machine.layout().size() * batch), q(dof * batch);
    for (std::size_t i = 0; i < dof; ++i)
      for (std::size_t k = 0; k < batch; ++k) q[i * batch + k] = at[i * boxes + k];
    return 1e9 *
           time_calls(rounds, static_cast<int>(4096 / batch),
                      [&](int) {
                        machine.place(PM_VALUE, batch, q.data(), placement.data());
                        return placement.back();
                      })
               .median /
           static_cast<double>(batch);
  };
  std::vector<int> strokes(dof), placed(machine.layout().size());
  for (std::size_t i = 0; i < dof; ++i) strokes[i] = static_cast<int>(machine.layout().actuator(static_cast<int>(i)));
  std::iota(placed.begin(), placed.end(), 0);
  const program::Program of_strokes = whole->slice(strokes), of_placement = whole->slice(placed);
  const auto row = [&](const char* what, double ns, std::size_t steps) {
    fmt::print("{:40}{:10.1f}{:>14}\n", what, ns, steps > 0 ? fmt::format("{}", steps) : "");
  };
  fmt::print("\n{}, through its plugin\n\n{:40}{:>10}{:>14}\n", machine.info().name, "", "ns", "operations");
  row("a pose by place, one at a time", time_place(1), 0);
  row("a pose by place, of 60", time_place(60), 0);
  row("a box: actuator values", time_boxes(of_strokes), of_strokes.steps().size());
  row("a box: all of the placement", time_boxes(of_placement), of_placement.steps().size());
  row("a box: the placement and G", time_boxes(*whole), whole->steps().size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma"))
      throw std::runtime_error("it is built for x86-64-v3, which this processor is not");
#endif
    hexapod_margins();
    recorded_programs(argc > 1 ? argv[1] : PLUGINS "/gough.so");
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
