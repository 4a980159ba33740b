// The axes of a joint in which its reaction is read: 1 along the joint's own axis, 2 and 3 across it.
//
//   revolute, prismatic, cylindrical, universal   1 along axis 1
//   spherical                                     1 along the z axis of its stud: along the leg
// Axis 2 of a universal joint lies along its second axis, as far as that is across the first. Else it is carried by body a, or by b where a
// is a slender leg, which has no sense of turning about itself, or by the base where both are: the base axis that stands most across axis 1
// at home, carried along, its share across axis 1.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

class JointFrames {
 public:
  explicit JointFrames(const Machine& machine);

  // Columns: axes 1, 2, 3 in base axes; orthonormal, right-handed.
  Eigen::Matrix3d operator()(const State& state, int joint) const;

  // How axes 1 and 2 are found, for those who work in lanes.
  struct Recipe {
    int stud = -1;                                    // body whose z axis is axis 1; -1: the joint's axis 1
    bool second_axis = false;                         // axis 2 from the joint's second axis
    int carrier = 0;                                  // body that carries `mark`; 0: the base
    Eigen::Vector3d mark = Eigen::Vector3d::UnitX();  // in the axes of the carrier
  };
  const Recipe& recipe(int joint) const { return recipes_[static_cast<std::size_t>(joint)]; }

 private:
  std::vector<Recipe> recipes_;
};

}  // namespace pmreport::mechanics
