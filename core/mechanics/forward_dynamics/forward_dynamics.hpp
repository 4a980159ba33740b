// Motion from forces: the independent coordinates integrated under given actuator forces.
//
//     M q'' = J^T tau + K^T load - c - g          (virtual_work.hpp)
#pragma once

#include <core/mechanics/dynamics/virtual_work.hpp>

#include <functional>
#include <string>
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

enum class ForwardEnd {
  none,         // it lasts to the last time
  limit,        // an actuator at the end of its stroke, or a joint at its limit
  singular,     // det G has fallen to nothing against that at home: the actuators no longer hold the platform
  unreachable,  // the edge of what can be assembled
  failed        // forces without a value, inertia that vanishes, or a motion too fast to be followed
};

struct ForwardMotion {
  // One row a time, one column a coordinate; NaN beyond the end. The accelerations are those of the equations of motion at value and rate.
  Eigen::MatrixXd value, rate, acceleration;
  // The same at any time from the first to the end; false elsewhere. Safe in threads; the machine and the problem's functions must live.
  std::function<bool(double t, double* value, double* rate, double* acceleration)> at;
  // Work of actuators and load since the start, integrated beside the motion, and the energy kinetic + potential at each time [J]; NaN
  // beyond the end.
  std::vector<double> work, energy;
  // The largest |energy - energy at the start - work| of all steps [J], and its share of the largest of what flowed and what is stored.
  double drift = 0, drift_share = 0;
  std::size_t steps = 0, evaluations = 0;
  ForwardEnd end = ForwardEnd::none;
  double ended = 0;    // [s]: the last time with a pose
  std::string ending;  // why it ends before the last time, "ends at t = 0.3141 s: rho3 (length of leg 3) reaches ..."; empty: it does not
};

// Dormand and Prince's steps of order 5(4), adaptive, none longer than 1/2000 of the whole: a force that acts as long as that is not
// stepped over. Ends, at the time found to 1e-9 s, where a stroke, a joint or a singular surface ends it, or where no step leads on. Throws
// MechanismError (PM_BAD_ARGUMENT) when no motion can begin: the start cannot be assembled, breaks a limit or is singular, a coordinate
// moves no mass, or a force has no finite value there.
ForwardMotion forward_dynamics(const Machine& machine, const ForwardProblem& problem);

}  // namespace pmreport::mechanics
