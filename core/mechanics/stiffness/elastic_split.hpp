// Joint reactions that rigid bodies leave open, settled by elasticity: (2) of elastostatics.hpp on the least-norm reactions of a motion.
#pragma once

#include <core/mechanics/stiffness/elastostatics.hpp>

#include <vector>

namespace pmreport::mechanics {

class ElasticSplit {
 public:
  explicit ElasticSplit(const Machine& machine) : plan_(machine) {}

  // The machine has elements; without them nothing is settled.
  bool any() const { return !plan_.machine().topology().elements.empty(); }

  // Pose k of `count` of `reactions`, which are least-norm. `placement`: its plain numbers, scalar s at [s * stride]. `joints`: the
  // reactions, to which the elastic self-stress is added.
  struct Answer {
    int settled = 0;                          // self-stresses
    std::vector<std::vector<Vector6d>> open;  // those that no element settles, as JointReactions::stresses
  };
  Answer add(const double* placement, std::size_t stride, const MotionReactions& reactions, std::size_t k, std::size_t count,
             std::vector<Vector6d>& joints);

 private:
  SpringPlan plan_;
  SpringPlan::AtPose parts_;
  std::vector<double> placement_;
};

}  // namespace pmreport::mechanics
