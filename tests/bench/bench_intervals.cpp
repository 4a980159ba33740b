// What a box of poses costs beside a pose, and beside other interval libraries: see README.md.
#include <fmt/core.h>

#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/program/intervals/boxes.hpp>
#include <tests/bench/interval_kernel.hpp>
#include <tests/bench/timing.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>
#include <random>

using namespace pmreport;
using namespace pmreport::bench;

namespace {

constexpr std::size_t boxes = 1024;
constexpr std::size_t batch = 60;  // of a recorded program: its results stay in the cache, and are no power of two apart
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

// What this thread had of the processor [ns]: what the neighbours had in between does not count.
double had() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}
template <class F>
double nanoseconds(int calls, F&& f) {
  const double start = had();
  double sum = 0;
  for (int k = 0; k < calls; ++k) sum += f();
  const double taken = had() - start;
  sink = sum;
  return taken / calls;
}

struct Each {
  double fastest, median;  // [ns]
};
// Of batches, the first of which only warms up.
template <class F>
Each each_of(std::size_t many, int calls, F&& f) {
  std::vector<double> all;
  for (int round = 0; round <= rounds; ++round)
    if (const double t = nanoseconds(calls, f) / static_cast<double>(many); round > 0) all.push_back(t);
  return {*std::min_element(all.begin(), all.end()), median(all)};
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
      const double t = nanoseconds(e.calls, [&] { return e.run(hexapod, sample); });
      if (round > 0) e.nanoseconds.push_back(t / boxes);
    }
  const auto ratio = [&](const Entry& of, const Entry& to) {
    std::vector<double> all;
    for (std::size_t i = 0; i < of.nanoseconds.size(); ++i) all.push_back(of.nanoseconds[i] / to.nanoseconds[i]);
    return median(all);
  };
  fmt::print("strokes and cones of a hexapod, {} boxes, {} rounds; medians\n\n{:40}{:>10}{:>10}{:>12}{:>12}\n", boxes, rounds, "",
             "ns a box", "fastest", "by a pose", "Arb by it");
  for (const Entry& e : entries)
    fmt::print("{:40}{:10.1f}{:10.1f}{:12.2f}{:12.1f}\n", e.name, median(e.nanoseconds),
               *std::min_element(e.nanoseconds.begin(), e.nanoseconds.end()), ratio(e, entries[0]), ratio(entries[6], e));
}

void recorded_programs(const char* file) {
  const host::PluginFile plugin = host::load_plugin(file);
  const mechanics::Machine machine(*plugin.mechanisms.at(0), mechanics::default_values(mechanics::describe(*plugin.mechanisms.at(0))));
  const program::Program* whole = machine.program();
  if (whole == nullptr) throw std::runtime_error("it records no program");

  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> share(0.3, 0.7);
  const std::size_t dof = static_cast<std::size_t>(machine.dof());
  std::vector<program::Bounds> in(dof * batch);
  std::vector<double> at(dof * batch);
  for (std::size_t i = 0; i < dof; ++i)
    for (std::size_t k = 0; k < batch; ++k) {
      const Range& box = machine.topology().coordinates[i].box;
      const double low = box.min + share(random) * (box.max - box.min);
      in[i * batch + k] = {low, low + 1e-3 * (box.max - box.min)};
      at[i * batch + k] = low;
    }
  const auto time_batch = [&](const program::Program& p) {
    program::Boxes runner(p);
    std::vector<program::Bounds> out(p.outputs().size() * batch);
    return each_of(batch, 32, [&] {
      runner.run(batch, in.data(), out.data());
      return out.back().high;
    });
  };
  const auto time_place = [&](std::size_t poses) {
    std::vector<double> placement(machine.layout().size() * poses), q(dof * poses);
    for (std::size_t i = 0; i < dof; ++i)
      for (std::size_t k = 0; k < poses; ++k) q[i * poses + k] = at[i * batch + k];
    return each_of(poses, static_cast<int>(4096 / poses), [&] {
      machine.place(PM_VALUE, poses, q.data(), placement.data());
      return placement.back();
    });
  };
  std::vector<int> strokes(dof), placed(machine.layout().size());
  for (std::size_t i = 0; i < dof; ++i) strokes[i] = static_cast<int>(machine.layout().actuator(static_cast<int>(i)));
  std::iota(placed.begin(), placed.end(), 0);
  const program::Program of_strokes = whole->slice(strokes), of_placement = whole->slice(placed);
  const auto row = [&](const std::string& what, const Each& t, std::size_t steps) {
    fmt::print("{:40}{:10.1f}{:10.1f}{:>12}\n", what, t.median, t.fastest, steps > 0 ? fmt::format("{}", steps) : "");
  };
  fmt::print("\n{}, through its plugin\n\n{:40}{:>10}{:>10}{:>12}\n", machine.info().name, "", "ns", "fastest", "operations");
  row("a pose by place, one at a time", time_place(1), 0);
  row(fmt::format("a pose by place, of {}", batch), time_place(batch), 0);
  row("a box of as many: actuator values", time_batch(of_strokes), of_strokes.steps().size());
  row("a box of as many: all of the placement", time_batch(of_placement), of_placement.steps().size());
  row("a box of as many: the placement and G", time_batch(*whole), whole->steps().size());
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
