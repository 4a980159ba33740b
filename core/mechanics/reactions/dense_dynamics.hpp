// Motions of mechanisms whose structure the limb-by-limb way does not fit: pose by pose over all bodies.
#pragma once

#include <core/mechanics/reactions/motion_reactions.hpp>

#include <optional>

namespace pmreport::mechanics {

class DenseDynamics {
 public:
  explicit DenseDynamics(const Machine& machine);

  // As InverseDynamics::solve. Reactions are found in any case, and left out of `out` where they are not asked for.
  void solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity, MotionReactions& out,
             bool reactions, const double* wrenches);

 private:
  JointReactions at_pose(std::size_t k, std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity,
                         const double* wrenches, double& regularity);

  const Machine& machine_;
  JointFrames frames_;
  double length_;
  State state_;
  GenericModel model_;
  std::optional<DenseSystem> system_;
  Eigen::VectorXd factorised_at_;  // coordinates
  double regularity_ = 0;
};

}  // namespace pmreport::mechanics
