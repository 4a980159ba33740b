// Prescribed actuators: the coordinates that follow them along a motion, with exact rates and accelerations. With l(q) the actuators and
// J = dl/dq,
//     l' = J q'                              (1)
//     l'' = J q'' + J' q'                    (2)
// give q' and q'' at a pose, and from these the pose h later is foretold,
//     q(t + h) = q + h q' + h^2 q'' / 2      (3)
// and found by forward displacement from there.
#pragma once

#include <Eigen/Core>
#include <core/mechanics/displacement/displacement.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

// The actuators at a time [s]: values, rates and accelerations, each dof long, SI.
using Drive = std::function<void(double t, double* value, double* rate, double* acceleration)>;

struct Waymark {  // on the way of the coordinates
  double time = 0;
  SmallVector value, rate, acceleration;
};

// One march along a branch of forward displacement. Keeps its buffers: make one a thread.
class Follower {
 public:
  Follower(const Machine& machine, const Drive& drive);

  // The waymark at coordinates `q`, at which the actuators have their values of time `t`.
  Waymark waymark(double t, const SmallVector& q);

  // Goes from `from` to time `to`, later or earlier, in steps as small as needed. Returns how far it comes, to `resolution` [s]: at `to`
  // unless an obstacle is in the way.
  struct Arrival {
    Waymark at;
    Outcome outcome = Outcome::good;  // or singular, or unreachable
    std::string why;                  // the mechanism's own reason, where it gives one
  };
  Arrival go(Waymark from, double to, double resolution);

 private:
  bool step(const Waymark& from, double to, SmallVector& q);
  double size_of(const SmallVector& dq) const;
  Arrival stopped(Waymark at, double direction, double resolution);
  std::optional<Matrix6d> wrenches(const SmallVector& q);
  int side(const SmallVector& q);
  double margin(const SmallVector& q);

  const Machine& machine_;
  const Drive& drive_;
  ForwardSolver solver_;
  SmallVector unit_;  // of each coordinate: a length of the mechanism's size, or a radian
  double length_;
  double largest_margin_ = 0;  // |det G_| on the way so far
  std::vector<double> values_, partials_, jets_;
};

struct FollowedMotion {
  Eigen::MatrixXd value, rate, acceleration;  // one row a time, SI; NaN from the obstacle on
  std::size_t reached = 0;                    // times with a pose
  Outcome outcome = Outcome::good;            // or singular, or unreachable
  double ending = 0;                          // the last time with a pose [s], to 1e-10 of the whole span
  std::string why;
};

// The coordinates at rising times, from `start`, where the actuators have their values of the first time.
FollowedMotion follow(const Machine& machine, const Drive& drive, const std::vector<double>& times, const SmallVector& start);

// Coordinates at the actuator values `actuators`, on the branch that leads straight there, in the space of actuators, from those of
// `start`. `share`: how much of the way is free, 1 when all.
struct Approach {
  SmallVector coordinates;
  double share = 0;
  Outcome outcome = Outcome::good;
  std::string why;
};
Approach approach(const Machine& machine, const SmallVector& start, const SmallVector& actuators);

// The actuators at a pose, dof numbers [m], [rad]; NaN where it cannot be assembled.
SmallVector actuators_at(const Machine& machine, const SmallVector& coordinates);

}  // namespace pmreport::mechanics
