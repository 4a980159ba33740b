// Systems of screws: what a limb lets the platform do (twists), what it then holds against (the wrenches that do no work on them), and a
// basis of such wrenches that a reader recognises.
#pragma once

#include <core/mechanics/mobility/screw.hpp>

#include <vector>

namespace pmreport::mechanics {

// A space of wrenches or of twists about one point, both as (linear; angular) = (force; moment) = (velocity; angular velocity), so that the
// power of a wrench on a twist is their plain product. 6 x dimension; the columns are a basis.
struct ScrewSystem {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // [m]
  Eigen::MatrixXd basis = Eigen::MatrixXd(6, 0);

  int dimension() const { return static_cast<int>(basis.cols()); }
};

// All wrenches that do no work on the twists, or the other way round.
ScrewSystem reciprocal(const ScrewSystem& system, double length);

struct Landmark {  // a point that has a name: the centre of a joint
  int joint;
  Eigen::Vector3d at;
};

struct NamedWrench {  // a wrench of a system, as it is told
  Vector6d wrench;    // (force; moment about the system's origin)
  Screw screw;
  int joint = -1;  // a force through the centre of this joint; -1: through none
};

// A basis of the wrenches: first the couples; then forces through landmarks, the point of most forces first and the earlier of two; what is
// left by its principal screws, the wrenches of extreme pitch (Hunt, Kinematic Geometry of Mechanisms, 1978, chapter 12). Directions are
// `aligned`.
std::vector<NamedWrench> readable_basis(const ScrewSystem& wrenches, const std::vector<Landmark>& landmarks, double length);

// Largest sine of an angle between a wrench of `a` and the space `b`, moments per length: 0 where b contains a. Twists weigh the other way
// round: give the inverse of the length for them.
double outside(const ScrewSystem& a, const ScrewSystem& b, double length);

}  // namespace pmreport::mechanics
