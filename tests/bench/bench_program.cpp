// What the recorded program costs: to record, to differentiate, and to scan with, beside `place` and loops written by hand. See README.md.
#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/program/batch.hpp>
#include <core/program/derivative.hpp>
#include <tests/bench/hand_written.hpp>
#include <tests/bench/timing.hpp>

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using bench::time_calls;
using bench::Timing;
using program::Program;

namespace {

constexpr int repetitions = 101;
constexpr std::size_t row = 500, rows = 8;  // poses of a row of the grid, along the first coordinate; the rows' other coordinates

host::PluginFile load(const std::string& name) { return host::load_plugin(PLUGINS "/" + name + ".so"); }

std::vector<int> numbers_from(int first, int count) {
  std::vector<int> out(static_cast<std::size_t>(count));
  std::iota(out.begin(), out.end(), first);
  return out;
}
std::size_t operations(const Program& p) {
  std::size_t n = 0;
  for (const program::Step& s : p.steps()) n += program::operands_of(s.operation) > 0;
  return n;
}

// One line a mechanism: what is recorded, how large it and its derivatives are, and how long that takes.
void print_sizes(const std::string& name) {
  const host::PluginFile file = load(name);
  const Machine machine(*file.mechanisms.front(), default_values(describe(*file.mechanisms.front())));
  const Program& all = *machine.program();
  const int dof = machine.dof();
  const std::vector<int> by = numbers_from(0, dof);
  const Program strokes = all.slice(numbers_from(static_cast<int>(machine.layout().actuator(0)), dof));

  std::vector<std::unique_ptr<Machine>> fresh;
  constexpr int calls = 1;
  for (int k = 0; k < (repetitions + 1) * calls; ++k) fresh.push_back(machine.with(machine.values()));
  std::size_t next = 0;
  const Timing record = time_calls(repetitions, calls, [&](int) { return double(fresh[next++]->program()->steps().size()); });
  const Timing partial = time_calls(repetitions, calls, [&](int) {
    const Program partials = program::partials(all, by);
    return double(partials.steps().size());
  });
  fmt::print("{:14} {:7}", name, machine.layout().size() + 36);
  for (const Program* p : {&all, &strokes})
    fmt::print("   {:5} {:5} {:5} {:5}", operations(*p), operations(program::in_time(*p, 1)), operations(program::in_time(*p, 2)),
               operations(program::partials(*p, by)));
  fmt::print("   {:5.2f} {:5.2f}   {:5.2f} {:5.2f}\n", 1e3 * record.median, 1e3 * record.fastest, 1e3 * partial.median,
             1e3 * partial.fastest);
}

// The rows that are scanned.
struct Grid {
  std::vector<double> first;                // of the poses of a row
  std::vector<std::vector<double>> others;  // all coordinates of each row; the first is not looked at
  explicit Grid(const Machine& machine) {
    const Topology& t = machine.topology();
    std::mt19937_64 random(1);
    for (std::size_t k = 0; k < row; ++k)
      first.push_back(t.coordinates[0].box.min + (t.coordinates[0].box.max - t.coordinates[0].box.min) * double(k) / double(row - 1));
    for (std::size_t r = 0; r < rows; ++r) {
      std::vector<double> q;
      for (const Coordinate& c : t.coordinates)
        q.push_back(c.home + (c.box.max - c.box.min) * 0.5 * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5));
      others.push_back(q);
    }
  }
};

// Ways to the actuator values of a row: each fills out[i * row + k] for actuator i of pose k.
struct Way {
  std::string name;
  std::function<void(const std::vector<double>& others, double* out)> run;
};

void compare(const Machine& machine, const Grid& grid, const std::vector<Way>& ways) {
  const std::size_t dof = static_cast<std::size_t>(machine.dof());
  std::vector<double> expected(dof * row), out((dof + 1) * row);
  for (const std::vector<double>& others : grid.others) {
    ways.front().run(others, expected.data());
    for (const Way& way : ways) {
      way.run(others, out.data());
      for (std::size_t i = 0; i < dof * row; ++i)
        if (!(std::abs(out[i] - expected[i]) < 1e-12)) {
          fmt::print(stderr, "{}: {} where {} has {}\n", way.name, out[i], ways.front().name, expected[i]);
          std::exit(1);
        }
    }
  }
  fmt::print("\n{}: actuator values along rows of {} poses\n{:52} {:>10} {:>8} {:>10} {:>8}\n", machine.info().name, row, "", "Mposes/s",
             "ratio", "fastest", "ratio");
  Timing first{};
  for (const Way& way : ways) {
    const Timing t = time_calls(repetitions, rows, [&](int k) {
      way.run(grid.others[static_cast<std::size_t>(k)], out.data());
      return out[dof * row - 1];
    });
    if (first.median == 0) first = t;
    fmt::print("{:52} {:10.1f} {:8.1f} {:10.1f} {:8.1f}\n", way.name, 1e-6 * row / t.median, first.median / t.median,
               1e-6 * row / t.fastest, first.fastest / t.fastest);
  }
}

Way place_in_lanes(const Machine& machine, const Grid& grid) {
  return {"place in lanes, whole placement, 60 poses at once", [&](const std::vector<double>& others, double* out) {
            constexpr std::size_t at_once = 60;
            static std::vector<double> q, placed;
            const std::size_t dof = others.size(), n = machine.layout().size();
            q.resize(dof * at_once), placed.resize(n * at_once);
            for (std::size_t start = 0; start < row; start += at_once) {
              const std::size_t count = std::min(at_once, row - start);
              for (std::size_t i = 0; i < dof; ++i)
                for (std::size_t k = 0; k < count; ++k) q[i * count + k] = i == 0 ? grid.first[start + k] : others[i];
              machine.place(PM_VALUE, count, q.data(), placed.data());
              for (std::size_t i = 0; i < dof; ++i)
                std::copy_n(placed.data() + machine.layout().actuator(static_cast<int>(i)) * count, count, out + i * row + start);
            }
          }};
}

Way in_batches(const std::string& name, const Grid& grid, program::Batch& batch) {
  return {name, [&](const std::vector<double>& others, double* out) { batch.run(row, others.data(), grid.first.data(), out); }};
}

// Six lengths |p + c_i|, c_i = R b_i - a_i known for the row, as one would write it for Gough's platform alone.
Way six_legs(const Machine& machine, const Grid& grid) {
  return {"by hand, a scalar loop over six legs", [&](const std::vector<double>& others, double* out) {
            std::vector<double> q = others;
            q[0] = grid.first[0];
            const Pose pose = machine.pose(q);
            Eigen::Vector3d c[6];
            for (int i = 0; i < 6; ++i) c[i] = machine.centre(pose, 3 * i + 2) - machine.centre(pose, 3 * i) - Eigen::Vector3d(q[0], 0, 0);
            for (std::size_t k = 0; k < row; ++k)
              for (std::size_t i = 0; i < 6; ++i) {
                const double x = grid.first[k] + c[i].x(), y = c[i].y(), z = c[i].z();
                out[i * row + k] = std::sqrt(x * x + y * y + z * z);
              }
          }};
}
Way four_sps_spr(const Grid& grid) {
  return {"by hand, inverse displacement pose by pose", [&](const std::vector<double>& others, double* out) {
            static const bench::HandWritten by_hand;
            std::vector<double> q = others;
            double length[5];
            bench::HandWritten::Point direction[5];
            for (std::size_t k = 0; k < row; ++k) {
              q[0] = grid.first[k];
              by_hand(q.data(), length, direction);
              for (std::size_t i = 0; i < 5; ++i) out[i * row + k] = length[i];
            }
          }};
}

void scan(const std::string& name) {
  const host::PluginFile file = load(name);
  const Machine machine(*file.mechanisms.front(), default_values(describe(*file.mechanisms.front())));
  const Grid grid(machine);
  const std::vector<int> strokes = numbers_from(static_cast<int>(machine.layout().actuator(0)), machine.dof());
  std::vector<int> strokes_and_reach = strokes;
  strokes_and_reach.push_back(0);
  const Program few = machine.program()->slice(strokes), more = machine.program()->slice(strokes_and_reach);
  program::Batch whole_few(few, 1), whole_more(more, 1);
  compare(machine, grid,
          {place_in_lanes(machine, grid), name == "gough" ? six_legs(machine, grid) : four_sps_spr(grid),
           in_batches(fmt::format("program in batches, strokes, {} operations a pose", operations(program::split(few, 1).inner)), grid,
                      whole_few),
           in_batches(fmt::format("with the reach, {} operations a pose", operations(program::split(more, 1).inner)), grid, whole_more)});
}

}  // namespace

int main() {
  fmt::print("operations, of everything and of the actuator values: the value, with rates, with accelerations, with partials\n");
  fmt::print("{:14} {:>7}   {:^23}   {:^23}   {:>11}   {}\n", "", "scalars", "everything", "actuators", "record [ms]",
             "partials [ms], median and fastest");
  for (const char* name : {"p2prpu-prps", "4sps-spr", "delta", "5pus-upu", "gough", "2q-spr", "stewart", "parallel-cross", "par4"})
    print_sizes(name);
  for (const char* name : {"gough", "4sps-spr"}) scan(name);
}
