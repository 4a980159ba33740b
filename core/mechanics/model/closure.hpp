// Do the bodies meet at the joints? At home, every joint centre and axis is expressed in the axes of both bodies that it connects; at any
// other pose both bodies carry theirs along, and the two must agree as far as the joint demands. The plugin's own word on where the joint
// is at that pose is not used. From the same comparison follows the motion of each joint from home, which its limits bound.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

struct ClosureError {
  double gap = 0;           // largest distance between the two images of a joint centre, across the axis where the joint slides [m]
  double misalignment = 0;  // largest angle between the two images of an axis, or of the relative orientation a prismatic joint keeps [rad]
  int gap_joint = -1, misalignment_joint = -1;
};

class Closure {
 public:
  explicit Closure(const Machine& machine);

  ClosureError error(const std::vector<BodyState>& bodies) const;

  // Motion of a joint from home, one value a limit: rotations and deflections [rad], travel [m]; signs and meaning as in plugin.h.
  std::vector<double> motion(const std::vector<BodyState>& bodies, int joint) const;

 private:
  struct Seat {  // a joint as one body holds it
    Eigen::Vector3d centre, axis[2];
  };
  struct Home {
    Seat a, b;
    Eigen::Matrix3d relative;  // rotation of b in a
    Eigen::Vector3d stud;      // spherical: z axis of the stud in the axes of the socket
  };
  const Machine& machine_;
  std::vector<Home> home_;
};

// The bodies of a pose at rest, for the functions above.
std::vector<BodyState> bodies_at_rest(const Machine& machine, const Pose& pose);

}  // namespace pmreport::mechanics
