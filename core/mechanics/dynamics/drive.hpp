// What stands between a motor and its actuator, and what a motion may ask of actuators and joints.
#pragma once

#include <limits>
#include <vector>

namespace pmreport::mechanics {

// Efficiency e in one of two conventions. `by_power`: losses take from the power that flows, whichever way. An actuator that pushes its
// load (force and rate of one sign) asks its drive for force / e; one that its load drives back leaves it force * e to hold.
// `always_divides`: force / e throughout, as in Zhang et al. 2016, Eq. (39). Of an actuator driven back it is not true: the drive would
// have to hold more than the load exerts, and would return more power than the load puts in.
enum class EfficiencyConvention { by_power, always_divides };

struct DriveTrain {
  double efficiency = 1;  // 0 < efficiency <= 1
  EfficiencyConvention convention = EfficiencyConvention::by_power;
  // Motor angle per actuator displacement: 2 pi / lead of a screw [rad/m], gear ratio of a rotary actuator. 0: no motor given.
  double ratio = 0;
  double inertia = 0;    // of screw and rotor about the motor's axis [kg m^2]; on the motor's side of the losses
  double stiffness = 0;  // in series with the actuator's force [N/m], [N m/rad]; 0: not given
  friend bool operator==(const DriveTrain&, const DriveTrain&) = default;
};

// What the drive must give at its actuator end for the actuator to exert `force` while it moves at `rate`. At rest it is taken to push, the
// larger of the two: it is about to.
double drive_force(const DriveTrain& drive, double force, double rate);
// Of the motor: torque = drive_force / ratio + inertia ratio acceleration, speed = ratio rate. Of a screw with lead h and inertia J:
// h / (2 pi) F + J (2 pi / h) q''.
struct MotorState {
  double torque = 0;  // [N m]
  double speed = 0;   // [rad/s]
  double power() const { return torque * speed; }
};
MotorState motor(const DriveTrain& drive, double force, double rate, double acceleration);  // ratio > 0

// Upper bounds of magnitudes; infinite: none. One entry an actuator, and one a joint.
struct MotionLimits {
  static constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> force, speed, power;        // of actuators: [N] or [N m], [m/s] or [rad/s], [W]
  std::vector<double> joint_force, joint_moment;  // of the reactions [N], [N m]
  bool any() const;
};

}  // namespace pmreport::mechanics
