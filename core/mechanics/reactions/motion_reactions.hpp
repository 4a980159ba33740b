// The reactions of every joint along a motion, as those who find them give them.
#pragma once

#include <core/mechanics/reactions/reactions.hpp>

#include <vector>

namespace pmreport::mechanics {

// Of `count` poses, number i of pose k at [i * count + k].
struct MotionReactions {
  std::vector<double> actuator_forces;       // dof numbers a pose, push positive
  std::vector<double> joints;                // 6 numbers a joint: what body a exerts on body b, as JointReactions::joints
  std::vector<Indeterminate> indeterminate;  // one a joint
  std::vector<double> stresses;              // 6 numbers a joint, stress after stress: orthogonal in the norm of reactions.hpp, of length 1
  std::vector<double> regularity;  // how far from singular, 1 at best: least pivot over largest; below 1e-9 the pose has NaN forces
  int stress_count = 0;            // dimension of the self-stress
};

}  // namespace pmreport::mechanics
