// The 4SPS-SPR plugin as its tests meet it.
#pragma once

#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine.hpp>

#include <map>
#include <stdexcept>

namespace pmreport::test {

inline const pm_mechanism& four_sps_spr() {
  static const host::PluginFile file = host::load_plugin(PLUGINS "/4sps-spr.so");
  return *file.mechanisms.at(0);
}

// Default parameters but for those named.
inline mechanics::ParameterValues values_with(const pm_mechanism& table, const std::map<std::string, std::vector<double>>& changes) {
  const mechanics::MechanismInfo info = mechanics::describe(table);
  mechanics::ParameterValues values = mechanics::default_values(info);
  std::size_t known = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto found = changes.find(info.parameters[i].name); found != changes.end()) values[i] = found->second, ++known;
  if (known != changes.size()) throw std::out_of_range("a parameter that the mechanism does not have");
  return values;
}

// Numbers of the choices of "dependent".
enum Dependent { x = 0, y, z, alpha, beta, gamma };
inline constexpr const char* pose_names[] = {"x", "y", "z", "alpha", "beta", "gamma"};

inline mechanics::Machine make_four_sps_spr(Dependent dependent = y) {
  return mechanics::Machine(four_sps_spr(), values_with(four_sps_spr(), {{"dependent", {static_cast<double>(dependent)}}}));
}

inline int joint_named(const mechanics::Machine& machine, const std::string& name) {
  const auto& joints = machine.topology().joints;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].name == name) return static_cast<int>(i);
  throw std::out_of_range("no joint is called " + name);
}

// The platform's pose x y z alpha beta gamma as the mechanism's independent coordinates.
inline std::vector<double> independent(const std::array<double, 6>& pose, Dependent dependent) {
  std::vector<double> q;
  for (std::size_t k = 0; k < 6; ++k)
    if (static_cast<int>(k) != dependent) q.push_back(pose[k]);
  return q;
}

}  // namespace pmreport::test
