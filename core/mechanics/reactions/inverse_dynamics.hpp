// Actuator forces and all joint reactions along a motion, limb by limb.
//
// Cut the mechanism loose from its platform: what is left falls into groups of bodies, each standing on the base (a limb; limbs that are
// joined to one another form one group). In each group a tree of joints reaches every body from the base; the wrench through a joint of the
// tree balances all that lies beyond it: with D_b what body b demands (momentum.hpp, less weight and load) and X_c what a cut joint exerts,
//     W_j = sum of D_b beyond j - sum of X_c beyond j                             (1)
// So the only unknowns are the reactions of the joints that the tree leaves out, those at the platform among them, and the only equations
// that each passive freedom s of a tree joint transmits nothing,
//     s . W_j = 0                                                                 (2)
// a few of both in a limb (a UPS leg: two equations, three unknowns) where the system over all bodies has 6 n. What they leave open is
// settled by the six equations of the platform P,
//     sum of X_c on P = D_P                                                       (3)
// and what those leave open is self-stress. The forces of actuators are the part of (1) along the freedoms that they drive.
#pragma once

#include <core/mechanics/reactions/motion_reactions.hpp>

#include <memory>

namespace pmreport::mechanics {

class InverseDynamics {
 public:
  explicit InverseDynamics(const Machine& machine);  // which must outlive it
  ~InverseDynamics();
  InverseDynamics(InverseDynamics&&) noexcept;

  // `jets`: coordinates with rates and accelerations as the contract has them, component c of coordinate i of pose k at
  // [(3 i + c) * count + k]. `loads`: 6 numbers a pose, the wrench on the platform, [c * count + k]. Poses out of reach give NaN.
  // `reactions` false: actuator forces alone. Reuses the memory of `out`. Keeps buffers: one object a thread.
  // `wrenches`: on each of the bodies 1..n, 6 numbers a body and pose, all about the platform's reference point, likewise; null: none.
  void solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity, MotionReactions& out,
             bool reactions = true, const double* wrenches = nullptr);
  // False where the structure is none that is cut at its platform: then one system over all bodies answers, as in `dense_reactions`.
  bool limb_by_limb() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace pmreport::mechanics
