// A machine as MuJoCo can take it: a tree of bodies, whose loops are closed by points that must coincide.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <string>
#include <vector>

namespace pmreport::judges {

// A joint that carries body `child` on body `parent`, one of which is its body a, the other b.
struct Branch {
  int joint, parent, child;
};

// Two bodies that have a point in common: body b and body a of `joint`.
struct Pin {
  int joint;
  Eigen::Vector3d on_b;  // in the axes of body b, from its origin [m]
};

struct Tree {
  std::vector<Branch> branches;  // outwards from the base: a parent before its children
  std::vector<Pin> pins;
};

// Every body hangs on one branch. A joint that closes a loop becomes one pin (spherical), or two on its axis (revolute). Throws
// std::invalid_argument where another kind of joint closes a loop; joints are chosen so that this happens only where all joints of a loop
// are of other kinds.
Tree tree_of(const mechanics::Machine& machine);

// Principal moments of inertia about the centre of mass [kg m^2], and axes, as columns in body axes.
struct Principal {
  Eigen::Vector3d moments;
  Eigen::Matrix3d axes;
};
Principal principal(const Inertia& inertia);

// The tree in MuJoCo's language, placed as the machine is at home. Body i is called "b<i>"; the freedoms of joint i are "j<i>_0",
// "j<i>_1", in the order in which they act from parent to child; a positive one moves body b along or about the axis as seen from body a.
// Bodies have their centres and principal axes, but unit mass and inertia: MuJoCo's compiler refuses what no solid can have, such as a
// motor's inertia that is counted as its arm's, or a slider of which nobody gave any.
std::string mjcf(const mechanics::Machine& machine, const Tree& tree);

// Axis k of a joint by the order in which its freedoms act, in the child's axes at home, signed as above. `k` < axes_of(kind).
Eigen::Vector3d branch_axis(const mechanics::Machine& machine, const Branch& branch, int k);

}  // namespace pmreport::judges
