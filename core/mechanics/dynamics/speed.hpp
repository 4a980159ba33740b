// How much faster a motion could run. Run `s` times as fast, a motion passes the same poses with s times the rates and s^2 times the
// accelerations; the load stays with the pose, not with the clock. A force is then F_rest + s^2 F_inertia, a power
// s v (F_rest + s^2 F_inertia), a reaction R_rest + s^2 R_inertia, so the largest s that a limit admits at a sample is the root of a
// polynomial, found exactly.
//
// A motion that is to run faster must get there from rest: s admits a limit only if every smaller s does. The power of an actuator whose
// inertia relieves it may break its limit at some speed and keep it again at a higher one; what counts is the first of the two. Forces and
// reactions know no such gap: they move on a straight line with s^2, and what a limit admits is convex.
#pragma once

#include <core/mechanics/dynamics/drive.hpp>

#include <Eigen/Core>
#include <vector>

namespace pmreport::mechanics {

// What one limit admits along the motion: the largest s at each sample; infinite where it never binds, 0 where it is broken even at rest,
// NaN where the motion has no number for it.
struct SpeedLimit {
  enum class Kind { actuator_force, actuator_speed, actuator_power, joint_force, joint_moment } kind;
  int index = 0;  // actuator, or joint
  std::vector<double> largest;
  int sample = -1;     // where it binds: at the least of `largest`; where that is 0, at the worst of them. -1: nowhere
  double at_rest = 0;  // of the limit, what is asked for there at rest: how much it is broken where `largest` is 0
};

struct FeasibleSpeed {
  // Largest s that no limit forbids anywhere; infinite without limits that bind; NaN when there are limits and not one number to hold
  // against them. Samples that are NaN do not count: whoever leaves poses out of a motion must say so beside it.
  double scale = 0;
  int limit = -1, sample = -1;     // which binds, and where: index into `limits`, the first of several, the worst at 0; -1: none
  std::vector<SpeedLimit> limits;  // those that are finite in MotionLimits: by kind in the order above, then by index
  std::vector<double> largest;     // at each sample, over all limits; NaN where any of them is
};

// Forces of actuators and reactions of joints along the motion, at rest in each pose and their inertial share as the motion stands; rows
// are samples. Reactions: 6 columns a joint (force; moment).
struct MotionForces {
  Eigen::MatrixXd actuator_rest, actuator_inertia, actuator_rate;
  Eigen::MatrixXd joint_rest, joint_inertia;
};
// Forces and powers are those of the actuators themselves: what a drive loses on the way is not in them. The matrices of joints may be
// empty where no limit is on a joint, those of actuators where none is on an actuator; all others have equally many rows.
FeasibleSpeed feasible_speed(const MotionForces& motion, const MotionLimits& limits);

// Largest s >= 0 such that all of [0, s] keep a limit; infinite: all do. `limit` > 0.
double speed_by_force(double rest, double inertia, double limit);               // |rest + s^2 inertia| <= limit
double speed_by_power(double rest, double inertia, double rate, double limit);  // s |rate| |rest + s^2 inertia| <= limit
double speed_by_reaction(const Eigen::Vector3d& rest, const Eigen::Vector3d& inertia, double limit);  // |rest + s^2 inertia| <= limit

}  // namespace pmreport::mechanics
