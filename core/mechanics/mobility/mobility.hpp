// What makes a mechanism move: the freedoms of its platform, what each limb allows it and holds it against, and the constraints that are
// more than needed.
#pragma once

#include <core/mechanics/mobility/loops.hpp>
#include <core/mechanics/mobility/wrench_system.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <vector>

namespace pmreport::mechanics {

// The motions of the platform with all actuators free, by the generic model. Twists and wrenches refer to the platform's reference point.
struct PlatformFreedoms {
  ScrewSystem twists, constraints;  // constraints: the wrenches that do no work on them
  Eigen::MatrixXd translations;     // 3 x t: directions in which the platform can move without turning, `aligned`
  Eigen::MatrixXd rotations;        // 3 x r: directions about which it can turn, with or without a translation, `aligned`
  int freedoms() const { return twists.dimension(); }
};
// `state.status` is PM_OK; `model` is its generic model, here and below.
PlatformFreedoms platform_freedoms(const Machine& machine, const State& state, const GenericModel& model);

// One limb between base and platform, the other limbs taken away. Bodies of no limb that it stands on belong to it.
struct LimbSystem {
  int limb = 0;
  std::vector<int> joints;          // those that touch a body of the limb, in the order of the topology
  std::vector<int> partners;        // other limbs whose bodies it is jointed to
  bool alone = true;                // it reaches the platform from the base by itself; else it has no systems of its own
  ScrewSystem twists, constraints;  // as of the platform
};
std::vector<LimbSystem> limb_systems(const Machine& machine, const State& state, const GenericModel& model);

// A redundant constraint as the self-stress that it allows: reactions of joints that balance one another without any load.
struct SelfStress {
  struct Share {
    int joint;
    Vector6d wrench;  // on body b of the joint (force; moment about the base's origin)
  };
  std::vector<Share> shares;  // of the joints that carry any of it
  NamedWrench at_first;       // that of the first share, in unit magnitude: force or couple 1
  bool same = true;           // every share is plus or minus that of the first: one wrench goes round a loop
  Loop loop;                  // the smallest loop that has it; empty where it takes several together
};
// As many as redundant constraints, by their loops, those of the smallest first.
std::vector<SelfStress> self_stresses(const Machine& machine, const State& state, const GenericModel& model);

// Centres of joints, as landmarks of `readable_basis`; the centre of a prismatic joint is any point of its travel, and none of these.
std::vector<Landmark> landmarks_of(const Topology& topology, const State& state, const std::vector<int>& joints);

}  // namespace pmreport::mechanics
