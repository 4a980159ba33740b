// Do the bodies meet at the joints? At home, the centre C and the axes n of every joint are expressed in the axes of both bodies that it
// connects: p_AC_A, n_A and p_BC_B, n_B. At any other pose both bodies carry theirs along, and with the names of state.hpp
//     gap      d = p_B + R_B p_BC_B - p_A - R_A p_AC_A, of a joint that slides its part across R_A n_A         (1)
//     turn     the angle between R_A n_A and R_B n_B; of a prismatic joint that of R_AB from what it was at home; of a universal joint by
//     how
//              much its two axes are not at right angles; of a spherical joint none                            (2)
// must vanish. The plugin's own word on where the joint is at that pose is not used. From the same comparison follows the motion of each
// joint from home, which its limits bound.
#pragma once

#include <core/mechanics/model/joint_motion.hpp>
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

  // `bodies`: all of them, base first, of which origins and rotations are read.
  ClosureError error(const std::vector<BodyState>& bodies) const;

  const JointHome& home(int joint) const { return home_[static_cast<std::size_t>(joint)]; }

  // Motion of a joint from home, one value a limit: rotations and deflections [rad], travel [m]; signs and meaning as in plugin.h.
  std::vector<double> motion(const std::vector<BodyState>& bodies, int joint) const;

 private:
  const Machine& machine_;
  std::vector<JointHome> home_;
};

// The bodies of a pose that is PM_OK, at rest, for the functions above.
std::vector<BodyState> bodies_at_rest(const Machine& machine, const Pose& pose);

}  // namespace pmreport::mechanics
