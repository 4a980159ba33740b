// The Par4 as its tests meet it.
#pragma once

#include <core/mechanics/model/state.hpp>
#include <tests/plugins/plugin.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace pmreport::test {

inline const pm_mechanism& par4() { return plugin("par4"); }

// Its sizes as written out for the tests [m]; limbs 1 and 2 hold the half at +X, 3 and 4 the other.
struct Par4Sizes {
  double base = 0.275, platform = 0.1, arm = 0.375, rod = 0.825, spacing = 0.08, half_bar = 0.055, half_hinges = 0.05;
};
inline constexpr double par4_azimuths[] = {-45 * std::numbers::pi / 180, 45 * std::numbers::pi / 180, 135 * std::numbers::pi / 180,
                                           225 * std::numbers::pi / 180};
inline Eigen::Vector3d outwards(int limb) { return {std::cos(par4_azimuths[limb]), std::sin(par4_azimuths[limb]), 0}; }
inline Eigen::Vector3d along_motor(int limb) { return {-std::sin(par4_azimuths[limb]), std::cos(par4_azimuths[limb]), 0}; }

// Halfway between the balls of a limb on the plate, with the tool at p and turned by theta; bars and hinge lines square at home.
inline Eigen::Vector3d wrist(const Par4Sizes& s, int limb, const Eigen::Vector3d& p, double theta) {
  const double side = limb < 2 ? 1 : -1;
  const Eigen::Vector3d middle = p - Eigen::Vector3d(0, s.half_hinges, 0);
  const Eigen::Vector3d swing = s.half_bar * Eigen::Vector3d(std::cos(theta) - 1, std::sin(theta), 0);
  return middle + s.platform * outwards(limb) + side * swing;
}

// At x y z theta, at rest unless told otherwise.
inline mechanics::State par4_at(const mechanics::Machine& machine, const Eigen::Vector4d& q,
                                const Eigen::Vector4d& rate = Eigen::Vector4d::Zero()) {
  const Eigen::Vector4d zero = Eigen::Vector4d::Zero();
  mechanics::State s;
  mechanics::evaluate(machine, q.data(), rate.data(), zero.data(), s);
  REQUIRE(s.status == PM_OK);
  return s;
}

}  // namespace pmreport::test
