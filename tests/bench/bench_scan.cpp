// What a grid costs: Glazunov's, of Gough's platform and of the parallel-cross mechanism, by the general program and by hand. See
// README.md.
#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/workspace/pose_limits.hpp>
#include <core/numbers.hpp>
#include <core/scan/grid.hpp>
#include <tests/bench/hand_scan.hpp>
#include <tests/bench/timing.hpp>

#include <fmt/core.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

using namespace pmreport;
using bench::HandScan;

namespace {

// x and y from -1.6 to 1.6 m, z above the base to as much; at each point orientations by 10 degrees up to 60 about each axis.
scan::Scan grid(double step) {
  const auto values = [step](double from, double to) { return static_cast<std::size_t>(std::lround((to - from) / step)) + 1; };
  scan::Scan s{{0, 0, 0, 0, 0, 0},
               {{0, -1.6, 1.6, values(-1.6, 1.6)}, {1, -1.6, 1.6, values(-1.6, 1.6)}, {2, step, 1.6 + step, values(step, 1.6 + step)}},
               {3, 4, 5},
               {}};
  for (int a = -6; a <= 6; ++a)
    for (int b = -6; b <= 6; ++b)
      for (int c = -6; c <= 6; ++c) s.orientations.push_back({10 * a * deg, 10 * b * deg, 10 * c * deg});
  return s;
}

scan::PoseSet limits(const mechanics::Machine& machine, bool crossed) {
  const std::vector<int> legs = crossed ? std::vector<int>{1, 2, 3} : std::vector<int>{1, 2, 3, 4, 5, 6};
  mechanics::LimitChoice choice{true, false, {}};
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  choice.asked.push_back({"base cone", mechanics::AskedAngle{legs, {0, up}}, 0, 60 * deg});
  choice.asked.push_back({"platform cone", mechanics::AskedAngle{legs, {machine.topology().platform, up}}, 0, 60 * deg});
  if (crossed) choice.asked.push_back({"hinges", mechanics::AskedValue{"derived"}, 15 * deg, 165 * deg});
  choice.asked.push_back({"distance", mechanics::AskedDistance{{1, 2, 3, 4, 5, 6}, {}, false}, 0.1, mechanics::open_end});
  const mechanics::PoseMargins m = mechanics::pose_margins(machine, choice).value();
  scan::PoseSet set{m.program, {}, {}};
  for (const mechanics::PoseMargin& margin : m.margins) set.rounding.push_back(margin.rounding);
  return set;
}

std::uint64_t by_hand(const scan::Scan& s, bool crossed) {
  std::vector<std::array<double, 3>> orientations;
  for (const auto& o : s.orientations) orientations.push_back({o[0], o[1], o[2]});
  const HandScan hand = crossed ? HandScan::parallel_cross(orientations) : HandScan::gough(orientations);
  std::uint64_t n = 0;
  for (std::size_t x = 0; x < s.points[0].count; ++x)
    for (std::size_t y = 0; y < s.points[1].count; ++y)
      for (std::size_t z = 0; z < s.points[2].count; ++z)
        n += hand.count({s.points[0].value(x), s.points[1].value(y), s.points[2].value(z)});
  return n;
}

struct Way {
  const char* name;
  std::size_t threads;
  std::function<std::uint64_t()> count;
};

void compare(const std::string& name, double step, int repetitions, std::size_t most) {
  const bool crossed = name != "gough";
  const host::PluginFile file = host::load_plugin(PLUGINS "/" + name + ".so");
  const mechanics::Machine machine(*file.mechanisms.front(), mechanics::default_values(mechanics::describe(*file.mechanisms.front())));
  const scan::PoseSet set = limits(machine, crossed);
  const scan::Scan s = grid(step);
  const double poses = static_cast<double>(s.point_count() * s.orientation_count());
  const auto counted = [&](bool prune, bool reasons) {
    scan::GridOptions options;
    options.prune = prune;
    options.reasons = reasons;
    return scan::count_grid(set, s, options).tally.accepted;
  };
  const Way ways[] = {{"by hand, scalar, out at the first that fails", 1, [&] { return by_hand(s, crossed); }},
                      {"every pose, one thread", 1, [&] { return counted(false, false); }},
                      {"every pose, two threads", 2, [&] { return counted(false, false); }},
                      {"pruned, one thread", 1, [&] { return counted(true, false); }},
                      {"pruned, two threads", 2, [&] { return counted(true, false); }},
                      {"pruned, with reasons, one thread", 1, [&] { return counted(true, true); }},
                      {"pruned, with reasons, two threads", 2, [&] { return counted(true, true); }}};
  fmt::print("\n{}: {:.1f} million poses, {} margins\n{:46} {:>9} {:>10} {:>8} {:>9}\n", name, 1e-6 * poses, set.size(), "", "s",
             "Mposes/s", "ratio", "accepted");
  double first = 0;
  std::uint64_t expected = 0;
  for (const Way& way : std::span(ways).first(std::min(most, std::size(ways)))) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, way.threads);
    std::uint64_t accepted = 0;
    const bench::Timing t = bench::time_calls(repetitions, 1, [&](int) { return static_cast<double>(accepted = way.count()); });
    if (first == 0) first = t.median, expected = accepted;
    fmt::print("{:46} {:9.3f} {:10.1f} {:8.2f} {:9}\n", way.name, t.median, 1e-6 * poses / t.median, first / t.median, accepted);
    if (accepted != expected) {
      fmt::print(stderr, "{}: {} accepted where {} are by hand\n", way.name, accepted, expected);
      std::exit(1);
    }
  }
}

}  // namespace

// Arguments: the step of the grid [m], 0.1 where there is none and 0.05 for Glazunov's own; how often each way is timed; how many ways, all
// where it is not told.
int main(int count, char** arguments) {
  const double step = count > 1 ? std::atof(arguments[1]) : 0.1;
  const int repetitions = count > 2 ? std::atoi(arguments[2]) : 3, ways = count > 3 ? std::atoi(arguments[3]) : 100;
  if (!(step >= 0.02 && step <= 0.4) || repetitions < 1 || ways < 1) {
    fmt::print(stderr, "expected a step from 0.02 to 0.4 m, and one repetition and one way or more\n");
    return 1;
  }
  for (const char* name : {"gough", "parallel-cross"}) compare(name, step, repetitions, static_cast<std::size_t>(ways));
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  fmt::print("\nmost memory in use: {} MiB\n", used.ru_maxrss / 1024);
}
