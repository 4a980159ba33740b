// The 2Q-SPR plugin as its tests meet it.
#pragma once

#include <core/mechanics/model/state.hpp>
#include <tests/plugins/plugin.hpp>
#include <tests/plugins/turning.hpp>

namespace pmreport::test {

inline const pm_mechanism& two_q_spr() { return plugin("2q-spr"); }

// The state of a mechanism whose platform is at x, z with rotation r, and moves so: x and z parts of velocity and acceleration, angular
// velocity and acceleration.
inline mechanics::State state_at(const mechanics::Machine& machine, const Eigen::Vector2d& xz, const Eigen::Matrix3d& r,
                                 const Eigen::Vector2d& v, const Eigen::Vector3d& w, const Eigen::Vector2d& a, const Eigen::Vector3d& e) {
  const Eigen::Vector3d angles = yaw_pitch_roll(r);
  const AngleRates turning = angle_rates(angles, w, e);
  Eigen::VectorXd q(5), rate(5), acceleration(5);
  q << xz, angles;
  rate << v, turning.rates;
  acceleration << a, turning.accelerations;
  mechanics::State s;
  mechanics::evaluate(machine, q.data(), rate.data(), acceleration.data(), s);
  return s;
}

}  // namespace pmreport::test
