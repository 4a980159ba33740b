// The 2Q-SPR plugin as its tests meet it.
#pragma once

#include <core/mechanics/model/state.hpp>
#include <tests/plugins/plugin.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace pmreport::test {

inline const pm_mechanism& two_q_spr() { return plugin("2q-spr"); }

// Yaw, pitch and roll of R = Rz Ry Rx; |pitch| < 90 degrees.
inline Eigen::Vector3d yaw_pitch_roll(const Eigen::Matrix3d& r) {
  return {std::atan2(r(1, 0), r(0, 0)), std::asin(-r(2, 0)), std::atan2(r(2, 1), r(2, 2))};
}

// Rates and accelerations of yaw, pitch and roll from the platform's angular velocity w and acceleration e. The axes of Rz Ry Rx are Z, Y1
// (turned by yaw) and X2 (turned by yaw and pitch): w = Z yaw' + Y1 pitch' + X2 roll'. The turning axes have the rates Y1' = yaw' Z x Y1
// and X2' = (yaw' Z + pitch' Y1) x X2, which e = w' brings along.
struct AngleRates {
  Eigen::Vector3d rates, accelerations;
};
inline AngleRates angle_rates(const Eigen::Vector3d& angles, const Eigen::Vector3d& w, const Eigen::Vector3d& e) {
  using Eigen::AngleAxisd, Eigen::Vector3d;
  const Vector3d z = Vector3d::UnitZ(), y1 = AngleAxisd(angles(0), z) * Vector3d::UnitY(),
                 x2 = AngleAxisd(angles(0), z) * AngleAxisd(angles(1), Vector3d::UnitY()) * Vector3d::UnitX();
  Eigen::Matrix3d axes;
  axes << z, y1, x2;
  const Eigen::Matrix3d inverse = axes.inverse();
  const Vector3d rates = inverse * w;
  const Vector3d y1_rate = rates(0) * z.cross(y1), x2_rate = (rates(0) * z + rates(1) * y1).cross(x2);
  return {rates, inverse * (e - y1_rate * rates(1) - x2_rate * rates(2))};
}

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
