// What acts on the mechanism along its motion, besides the actuators.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace pmreport::scenario {

struct Load {                                               // wrench on the platform at its reference point, base axes, at every sample
  std::vector<Eigen::Vector3d> force, moment;               // [N], [N m]
  Eigen::Vector3d gravity{0, 0, 0};                         // [m/s^2]; none unless the scenario gives it: the bodies are weightless then
  std::function<Eigen::Matrix<double, 6, 1>(double t)> at;  // force and moment at any time of the motion
  std::vector<double> knots;                                // rising: times inside the motion at which it may be anything but smooth
  std::vector<double> steps;                                // rising: between two neighbours a handful of points show all that it does
  std::string description;
};

}  // namespace pmreport::scenario
