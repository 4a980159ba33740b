// How far a pose is from the end of the mechanism's reach, a singularity of type 1: a limb is stretched, or folded, and its actuator can no
// longer move the platform outwards.
//
// There the actuator goes as the root of what is left of the way, l = l_0 - c sqrt(s). Along the direction of steepest change of l the
// first two derivatives by the way already gone give
//     l' = c / (2 sqrt(s)),   l'' = c / (4 s sqrt(s)),   s = l' / (2 l'')                 (1)
// from however far or near. Of an actuator that is nowhere near such an end (1) is of the size of the mechanism or more.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/model/state.hpp>

#include <optional>
#include <vector>

namespace pmreport::mechanics {

struct EndOfReach {
  double distance = 0;         // s of the nearest [m]; angles count as ways at the characteristic length
  std::vector<int> actuators;  // whose ends are that near, to twice the distance
};
// At coordinates [m], [rad]: nothing where no end is nearer than `near_end` of the mechanism's characteristic length, `length` [m], or
// where the pose has no rates.
constexpr double near_end = 0.02;
std::optional<EndOfReach> end_of_reach(const Machine& machine, const SmallVector& coordinates, double length);

}  // namespace pmreport::mechanics
