// Motion from forces: the independent coordinates integrated under given actuator forces.
//
//     M q'' = J^T tau + K^T load - c - g          (virtual_work.hpp)
#pragma once

#include <core/mechanics/virtual_work.hpp>

#include <functional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct ForwardProblem {
  // Forces of the actuators at a time, given their values and rates, push positive; dof long.
  std::function<void(double t, const std::vector<Scalar>& actuators, double* forces)> actuator_forces;
  std::function<Vector6d(double t)> load;  // on the platform, as in Loading
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  Eigen::VectorXd start, start_rate;  // dof long
  std::vector<double> times;          // at which the motion is wanted, increasing; the first is the start
  double tolerance = 1e-10;           // of a step, relative and absolute, lengths per characteristic length
};

struct ForwardMotion {
  Eigen::MatrixXd value, rate, acceleration;  // one row a time, one column a coordinate; NaN beyond the end
  // Work of actuators and load since the start, integrated beside the motion, and the energy kinetic + potential at each time [J].
  std::vector<double> work, energy;
  double drift = 0;  // largest |energy - its start - work|, over the largest of what flowed and what is stored
  std::size_t steps = 0, evaluations = 0;
  double ended = 0;    // [s]
  std::string ending;  // why it ends before the last time: "rho3 (length of leg 3) reaches the end of its stroke ..."; empty: it does not
};
// Adaptive Dormand-Prince steps with dense output. Ends, at the time found to 1e-9 s, where an actuator reaches the end of its stroke or a
// joint its limit, where det J vanishes, or where the mechanism falls apart.
ForwardMotion forward_dynamics(const Machine& machine, const ForwardProblem& problem);

}  // namespace pmreport::mechanics
