// A plugin as its tests meet it.
#pragma once

#include <core/host/plugin_file.hpp>
#include <core/mechanics/machine/machine.hpp>

#include <map>
#include <stdexcept>
#include <string>

namespace pmreport::test {

// The first mechanism of a plugin, by the plugin's name.
inline const pm_mechanism& plugin(const std::string& name) {
  static std::map<std::string, host::PluginFile> files;
  auto found = files.find(name);
  if (found == files.end()) found = files.emplace(name, host::load_plugin(PLUGINS "/" + name + ".so")).first;
  return *found->second.mechanisms.at(0);
}

// Default parameters but for those named; of a choice its index.
inline mechanics::ParameterValues values_with(const pm_mechanism& table, const std::map<std::string, std::vector<double>>& changes) {
  const mechanics::MechanismInfo info = mechanics::describe(table);
  mechanics::ParameterValues values = mechanics::default_values(info);
  std::size_t known = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const auto found = changes.find(info.parameters[i].name); found != changes.end()) values[i] = found->second, ++known;
  if (known != changes.size()) throw std::out_of_range("a parameter that the mechanism does not have");
  return values;
}

// Index of a word of a choice.
inline double choice(const pm_mechanism& table, const std::string& parameter, const std::string& word) {
  for (const mechanics::ParameterInfo& p : mechanics::describe(table).parameters)
    if (p.name == parameter)
      for (std::size_t i = 0; i < p.choices.size(); ++i)
        if (p.choices[i] == word) return static_cast<double>(i);
  throw std::out_of_range("no choice " + word + " of " + parameter);
}

inline int joint_named(const mechanics::Machine& machine, const std::string& name) {
  const auto& joints = machine.topology().joints;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].name == name) return static_cast<int>(i);
  throw std::out_of_range("no joint is called " + name);
}

}  // namespace pmreport::test
