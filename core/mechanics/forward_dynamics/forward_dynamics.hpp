// Motion from forces: the independent coordinates integrated under given actuator forces.
//
//     M q'' = J^T tau + K^T load - c - g                              (1), by virtual_work.hpp
//     W' = (J^T tau + K^T load) . q'                                  (2), the power of actuators and load
//     T + U - W = T + U at the start                                  (3), what the integration must keep
// Numbers are integrated in sizes: q_i = s_i x_i with s_i a characteristic length or a radian, W in joules of the mechanism moving at s.
#pragma once

#include <core/mechanics/forward_dynamics/forward_problem.hpp>
#include <core/mechanics/model/outcome.hpp>

#include <functional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

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
  Outcome outcome = Outcome::good;  // why it ends; good: it lasts to the last time
  double ended = 0;                 // [s]: the last time with a pose
  std::string ending;  // why it ends before the last time, "ends at t = 0.3141 s: rho3 (length of leg 3) reaches ..."; empty: it does not
};

// Dormand and Prince's steps of order 5(4), adaptive, none longer than 1/2000 of the whole: a force that acts as long as that is not
// stepped over. Ends, at the time found to 1e-9 s, where a stroke, a joint or a singular surface ends it, or where no step leads on. Throws
// MechanismError (PM_BAD_ARGUMENT) when no motion can begin: the start cannot be assembled, breaks a limit or is singular, a coordinate
// moves no mass, or a force has no finite value there.
ForwardMotion forward_dynamics(const Machine& machine, const ForwardProblem& problem);

}  // namespace pmreport::mechanics
