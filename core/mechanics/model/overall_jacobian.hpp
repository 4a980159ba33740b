// The plugin's overall Jacobian G apart from its units, and apart from its levers.
//
// With a length L [m], moments count per length and rows whose magnitude is a couple, or belongs to a rotary actuator, in lengths:
//     G^ = D G diag(1, 1, 1, 1/L, 1/L, 1/L)                    (1)
// D = L for these rows, else 1. Its singular values compare velocities v with L w, and forces with couples per L.
//
// An actuator that acts through a lever has a row that is its wrench over the lever: near the end of reach, where the lever vanishes, G^
// grows without bound although the wrenches on the platform are as they were. What the limbs hold the platform with is told by the wrenches
// themselves, the rows of
//     G_ = diag(1 / |row|) G^                                  (2)
// which has the sign of det G, is zero where the wrenches depend on one another and never infinite.
#pragma once

#include <core/mechanics/machine/machine.hpp>

namespace pmreport::mechanics {

linear::Matrix6d dimensionless(const Machine& machine, const linear::Matrix6d& jacobian, double length);  // (1)
linear::Matrix6d unit_wrenches(const linear::Matrix6d& jacobian, double length);                          // (2)

// The side of the singular surface that a pose is on: the sign of det G, 0 where rounding could turn it over (linear::sign_of_determinant)
// and where G is not known.
int side_of(const linear::Matrix6d& jacobian, double length);

}  // namespace pmreport::mechanics
