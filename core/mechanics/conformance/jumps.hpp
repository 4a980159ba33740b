// Quantities that jump: an angle whose arc tangent passes its cut changes by a turn between two poses that touch.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <optional>
#include <string>

namespace pmreport::mechanics {

struct Jump {
  std::string quantity;  // an actuator, or a derived quantity
  std::string unit;      // "m" or "rad"
  double by = 0;
  Eigen::VectorXd at;  // coordinates of the pose where it is
};

// The first jump of an actuator or derived quantity, in m by more than `length` [m] or in rad by more than half a turn, along the straight
// path between two poses. Nothing when there is none; what lies beyond the edge of reach is not looked at.
std::optional<Jump> jump_between(const Machine& machine, const Eigen::VectorXd& from, const Eigen::VectorXd& to, double length);

}  // namespace pmreport::mechanics
