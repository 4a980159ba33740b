// What the search of all assembly modes costs, on one core.
#include <core/host/plugin_file.hpp>
#include <core/mechanics/assembly/assembly.hpp>
#include <tests/bench/timing.hpp>

#include <fmt/core.h>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

void measure(const std::string& name, const Machine& machine, const Eigen::VectorXd& actuators) {
  AssemblyModes found = find_assembly_modes(machine, actuators, machine.home());
  const bench::Timing t =
      bench::time_calls(5, 1, [&](int) { return double(find_assembly_modes(machine, actuators, machine.home()).modes.size()); });
  fmt::print("{:<18}{:>6}{:>10}{:>10}{:>12}{:>12.1f}{:>12.1f}\n", name, found.modes.size(), found.starts, found.curves, found.placements,
             1e3 * t.median, 1e3 * t.fastest);
}

// Default parameters but for those given.
Machine make(const pm_mechanism& table, const std::vector<std::pair<std::string, std::vector<double>>>& changes) {
  const MechanismInfo info = describe(table);
  ParameterValues values = default_values(info);
  for (const auto& [name, value] : changes)
    for (std::size_t i = 0; i < values.size(); ++i)
      if (info.parameters[i].name == name) values[i] = value;
  return Machine(table, values);
}

std::vector<double> flat(const nlohmann::json& points) {
  std::vector<double> out;
  for (const auto& p : points)
    for (const double x : p) out.push_back(x);
  return out;
}

}  // namespace

int main() {
  try {
    fmt::print("{:<18}{:>6}{:>10}{:>10}{:>12}{:>12}{:>12}\n", "mechanism", "modes", "starts", "curves", "placements", "median, ms",
               "fastest");
    std::ifstream file(TEST_DATA "/dietmaier.json");
    const nlohmann::json d = nlohmann::json::parse(file);
    const host::PluginFile gough = host::load_plugin(PLUGINS "/gough.so");
    const std::vector<double> lengths = d["L"];
    measure("Dietmaier", make(*gough.mechanisms.at(0), {{"base_points", flat(d["a"])}, {"platform_points", flat(d["b"])}}),
            Eigen::Map<const Eigen::VectorXd>(lengths.data(), 6));
    for (const std::string name : {"4sps-spr", "2q-spr", "5pus-upu", "p2prpu-prps", "gough", "stewart", "parallel-cross", "delta"}) {
      const host::PluginFile plugin = host::load_plugin(PLUGINS "/" + name + ".so");
      const Machine machine = make(*plugin.mechanisms.at(0), {});
      const Pose& home = machine.home_pose();
      measure(name, machine, Eigen::Map<const Eigen::VectorXd>(home.numbers.data() + machine.layout().actuator(0), machine.dof()));
    }
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
