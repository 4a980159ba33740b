// The 4SPS-SPR plugin as its tests meet it.
#pragma once

#include <tests/plugins/plugin.hpp>

namespace pmreport::test {

inline const pm_mechanism& four_sps_spr() { return plugin("4sps-spr"); }

// Numbers of the choices of "dependent".
enum Dependent { x = 0, y, z, alpha, beta, gamma };
inline constexpr const char* pose_names[] = {"x", "y", "z", "alpha", "beta", "gamma"};

inline mechanics::Machine make_four_sps_spr(Dependent dependent = y) {
  return mechanics::Machine(four_sps_spr(), values_with(four_sps_spr(), {{"dependent", {static_cast<double>(dependent)}}}));
}

// The platform's pose x y z alpha beta gamma as the mechanism's independent coordinates.
inline std::vector<double> independent(const std::array<double, 6>& pose, Dependent dependent) {
  std::vector<double> q;
  for (std::size_t k = 0; k < 6; ++k)
    if (static_cast<int>(k) != dependent) q.push_back(pose[k]);
  return q;
}

}  // namespace pmreport::test
