// How much faster a motion could run. Run `s` times as fast, a motion passes the same poses with s times the rates and s^2 times the
// accelerations; a force is then F_rest + s^2 F_inertia, a power s v (F_rest + s^2 F_inertia), a reaction R_rest + s^2 R_inertia, so the
// largest s that a limit admits at a sample is the root of a polynomial, found exactly.
#pragma once

#include <core/mechanics/drive.hpp>

#include <Eigen/Core>
#include <string>
#include <vector>

namespace pmreport::mechanics {

// What one limit admits along the motion: the largest s at each sample; infinite where it never binds, 0 where it is broken even at rest.
struct SpeedLimit {
  enum class Kind { actuator_force, actuator_speed, actuator_power, joint_force, joint_moment } kind;
  int index = 0;  // actuator, or joint
  std::vector<double> largest;
};

struct FeasibleSpeed {
  double scale = 0;                // largest s that no limit forbids anywhere; infinite without limits that bind
  int limit = -1, sample = -1;     // which binds, and where: index into `limits`
  std::vector<SpeedLimit> limits;  // those that are finite in MotionLimits
  std::vector<double> largest;     // at each sample, over all limits
};

// Forces of actuators and reactions of joints along the motion, at rest in each pose and their inertial share as the motion stands; rows
// are samples. Reactions: 6 columns a joint (force; moment).
struct MotionForces {
  Eigen::MatrixXd actuator_rest, actuator_inertia, actuator_rate;
  Eigen::MatrixXd joint_rest, joint_inertia;
};
FeasibleSpeed feasible_speed(const MotionForces& motion, const MotionLimits& limits);

}  // namespace pmreport::mechanics
