// The Delta robot as its tests meet it.
#pragma once

#include <tests/plugins/plugin.hpp>

namespace pmreport::test {

inline const pm_mechanism& delta() { return plugin("delta"); }

// Its sizes as written out for the tests: base and platform radius, arm and rod length [m]; azimuths of the limbs [rad].
struct DeltaSizes {
  double base = 0.2, platform = 0.08, arm = 0.524, rod = 1.244;
};
inline constexpr double delta_azimuths[] = {-90 * std::numbers::pi / 180, 30 * std::numbers::pi / 180, 150 * std::numbers::pi / 180};

inline mechanics::ParameterValues delta_values(const DeltaSizes& s, std::map<std::string, std::vector<double>> more = {}) {
  more.insert({{"base_radius", {s.base}}, {"platform_radius", {s.platform}}, {"arm_length", {s.arm}}, {"rod_length", {s.rod}}});
  return values_with(delta(), more);
}
inline std::map<std::string, std::vector<double>> all_elbows(double choice) {
  return {{"elbow1", {choice}}, {"elbow2", {choice}}, {"elbow3", {choice}}};
}

}  // namespace pmreport::test
