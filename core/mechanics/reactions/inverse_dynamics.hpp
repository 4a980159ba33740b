// Actuator forces and all joint reactions along a motion, limb by limb.
//
// Cut the mechanism loose from its platform: what is left falls into groups of bodies, each standing on the base (a limb; limbs that are
// joined to one another form one group). In each group a tree of joints reaches every body from the base; the wrench through a joint of the
// tree balances all that lies beyond it. So the only unknowns are the reactions of the joints that the tree leaves out, those at the
// platform among them, and the only equations that each passive freedom of a tree joint transmits nothing: a few of both in a limb (a UPS
// leg: two equations, three unknowns) where the system over all bodies has 6 n. What they leave open is settled by the six equations of the
// platform; what those leave open is self-stress.
#pragma once

#include <core/mechanics/reactions/reactions.hpp>

#include <memory>

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

class InverseDynamics {
 public:
  explicit InverseDynamics(const Machine& machine);  // which must outlive it
  ~InverseDynamics();
  InverseDynamics(InverseDynamics&&) noexcept;

  // `jets`: coordinates with rates and accelerations as the contract has them, component c of coordinate i of pose k at
  // [(3 i + c) * count + k]. `loads`: 6 numbers a pose, the wrench on the platform, [c * count + k]. Poses out of reach give NaN.
  // `reactions` false: actuator forces alone. Reuses the memory of `out`. Keeps buffers: one object a thread.
  void solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity, MotionReactions& out,
             bool reactions = true);

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace pmreport::mechanics
