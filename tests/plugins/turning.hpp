// Yaw, pitch and roll of a platform, R = Rz Ry Rx, and their rates, as reference cases need them that speak of rotations and twists.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>

namespace pmreport::test {

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

}  // namespace pmreport::test
