// A mechanism under given forces, from a given start: what is asked.
#pragma once

#include <core/mechanics/model/state.hpp>

#include <functional>
#include <vector>

namespace pmreport::mechanics {

struct ForwardProblem {
  // Forces of the actuators [N], [N m] at a time, given their values and rates, push positive; dof long.
  std::function<void(double t, const std::vector<Scalar>& actuators, double* forces)> actuator_forces;
  std::function<Vector6d(double t)> load;  // on the platform, as in Loading; none: no load
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  Eigen::VectorXd start, start_rate;    // dof long
  std::vector<double> times;            // at which the motion is wanted, rising; the first is the start
  double tolerance = 1e-10;             // of a step, relative; absolute a hundredth of it, lengths per characteristic length
  std::size_t evaluations = 1'000'000;  // of the equations of motion by the steps, at most
};

}  // namespace pmreport::mechanics
