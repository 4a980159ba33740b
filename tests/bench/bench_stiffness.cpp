// What elasticity costs, for every mechanism through its plugin: see README.md.
#include <fmt/core.h>

#include <core/analysis/stiffness/numbers.hpp>
#include <core/analysis/study/pose_map.hpp>
#include <core/host/plugin_file.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/stiffness/whole_system.hpp>
#include <tests/bench/timing.hpp>

#include <chrono>
#include <memory>
#include <string>

using namespace pmreport;
using namespace pmreport::mechanics;
using bench::time_calls;

namespace {

const Eigen::Vector3d gravity(0, 0, -9.81);
const Vector6d load = (Vector6d() << 100, -50, 200, 3, -2, 1).finished();

double microseconds(const bench::Timing& t) { return 1e6 * t.median; }

// All indices of a pose: compliance, six singular values, stiffness with its eigenscrews, natural frequencies.
double indices(const Matrix6d& compliance, const Matrix6d& inertia, double length) {
  double sum = deformation_indices(compliance).pF_max;
  if (const auto k = stiffness_of(compliance, length)) sum += eigenscrews(*k)[0].lambda;
  const auto all = modes(compliance, inertia, length);
  return sum + (all.empty() ? 0 : all.front().frequency);
}

// Wall time of the fastest of three [s].
template <class F>
double seconds(F&& f) {
  double best = 1e99;
  for (int k = 0; k < 3; ++k) {
    const auto start = std::chrono::steady_clock::now();
    f();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  return best;
}

void run(const Machine& machine) {
  const double length = characteristic_length(machine);
  const std::vector<Eigen::VectorXd> poses = random_poses(machine, 64, 1);
  if (poses.empty()) throw std::runtime_error("no pose of " + machine.info().name + " can be assembled");
  Elastostatics statics(machine);
  int turn = 0;
  const auto next = [&]() -> const Eigen::VectorXd& {
    return poses[static_cast<std::size_t>(turn = (turn + 1) % static_cast<int>(poses.size()))];
  };
  const auto timed = [&](const Elastostatics::Wanted& wanted) {
    return microseconds(time_calls(25, 64, [&](int) {
      const ElasticPose p = statics.at(next(), load, gravity, wanted);
      return indices(p.compliance, wanted.limb_inertia ? p.inertia : p.platform_inertia, length);
    }));
  };
  const double pose = timed({false, false}), loaded = timed({true, false}), limbs = timed({true, true});
  const double whole = microseconds(time_calls(5, 4, [&](int) {
    const State s = state_at_rest(machine, next());
    const Matrix6d c = WholeSystem(statics.plan(), s).under_unit_wrenches().middleRows<6>(6 * machine.topology().platform - 6);
    return indices(c, c, length);
  }));

  analysis::PoseMap map;
  map.at = machine.home();
  for (int k = 0; k < 2; ++k) {
    const Coordinate& c = machine.topology().coordinates[static_cast<std::size_t>(map.coordinate[k])];
    map.from[k] = c.box.min, map.to[k] = c.box.max;
  }
  const auto mapped = [&](bool with_limbs) {
    return seconds([&] {
      const auto all = analysis::over_map(map, 1, [&] {
        return [&, own = std::make_shared<Elastostatics>(machine)](std::span<const double> q, std::span<double> out) {
          const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size()));
          const ElasticPose p = own->at(at, load, gravity, {false, with_limbs});
          if (!p.known) return;
          out[0] = indices(p.compliance, p.platform_inertia, length);
          if (with_limbs) out[0] += analysis::frequencies(p, true, length).front();
        };
      });
      bench::sink = all[0][0];
    });
  };
  const double map_of_indices = mapped(false), map_with_limbs = mapped(true);
  fmt::print("{:<15} {:>9.1f} {:>9.1f} {:>9.1f} {:>9.0f} {:>8.0f} {:>8.3f} {:>9.3f}\n", machine.info().name, pose, loaded, limbs, whole,
             whole / pose, map_of_indices, map_with_limbs);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = {"gough", "stewart", "parallel-cross", "4sps-spr", "5pus-upu", "2q-spr", "p2prpu-prps", "delta", "par4"};
  fmt::print("{:<15} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>9}\n", "mechanism", "pose us", "loads us", "limbs us", "whole us", "ratio",
             "61x61 s", "limbs s");
  for (const std::string& name : names) {
    const host::PluginFile file = host::load_plugin(std::string(PLUGINS) + "/" + name + ".so");
    run(Machine(*file.mechanisms.at(0), default_values(describe(*file.mechanisms.at(0)))));
  }
}
