// The 5PUS-UPU as its tests meet it.
#pragma once

#include <core/mechanics/model/generic_model.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/five_freedoms.hpp>
#include <tests/plugins/plugin.hpp>

namespace pmreport::test {

inline const pm_mechanism& five_pus_upu() { return plugin("5pus-upu"); }

using Changes = std::map<std::string, std::vector<double>>;

// Changes of the parameters for what the reference calls a model.
inline Changes model(const std::string& name) {
  return {{"constraint", {choice(five_pus_upu(), "constraint", name == "ideal_gamma0" ? "ideal" : "upu")}}};
}

// Centres of the balls S1 to S5, one below the other.
inline Eigen::VectorXd balls(const mechanics::Machine& machine, const mechanics::State& s) {
  Eigen::VectorXd all(15);
  for (int i = 0; i < 5; ++i)
    all.segment<3>(3 * i) = s.joints[static_cast<std::size_t>(joint_named(machine, "S" + std::to_string(i + 1)))].centre;
  return all;
}

}  // namespace pmreport::test
