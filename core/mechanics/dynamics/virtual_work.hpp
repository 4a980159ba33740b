// Dynamics in the independent coordinates, by virtual work with the exact partials of `place`.
//
// For every admissible displacement dq, with dl = J dq of the actuators and K dq of the bodies (displacement of the origin; rotation),
//     tau . J dq + (applied - inertial) . K dq = 0,   hence   tau = J^-T K^T (inertial - applied)        (1)
// the joints do no work, and no reaction enters. With inertial = M_b K q'' + terms of the rates, the same sums give the equations of motion
//     M q'' + c + g = J^T tau + K^T load,   M = K^T M_b K                                                (2)
// in which M_b has the mass matrices of the bodies on its diagonal. In the actuators' rates l' = J q' the kinetic energy is
// l' . (J^-T M J^-1) l' / 2                                                                              (3)
#pragma once

#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/model/tangent.hpp>

namespace pmreport::mechanics {

// The actuator forces, push positive, [N] or [N m], by what asks for them. They sum to the whole.
struct ForceShares {
  SmallVector load, gravity, inertia;
  SmallVector total() const { return load + gravity + inertia; }
};
// By (1), each share of the wrenches apart, in the motions of the tangent, whatever they are. J is singular where the actuators do not hold
// the platform: then the forces are not finite, or large.
ForceShares virtual_work(const Machine& machine, const State& state, const Tangent& tangent, const Loading& loading);

// The share of the weights alone, at rest or not.
SmallVector weight_forces(const Machine& machine, const State& state, const Eigen::Vector3d& gravity);

// M q'' + coriolis + gravity = J^T tau + K^T load. Units by coordinate: N, or N m where it is an angle.
struct EquationsOfMotion {
  SmallMatrix mass;      // M, symmetric positive definite: kinetic energy q' M q' / 2
  SmallVector coriolis;  // centrifugal and Coriolis terms at the rates of the state
  SmallVector gravity;
};
// (2), at the coordinates and rates of `state`; its accelerations play no part. `gravity` [m/s^2]. In the motions of the tangent, which are
// those of the coordinates only while tangent.by_coordinates.
EquationsOfMotion equations_of_motion(const Machine& machine, const State& state, const Tangent& tangent, const Eigen::Vector3d& gravity);

// The inertia that each actuator feels, the other actuators held: diagonal of (3) [kg], or [kg m^2] of a rotary actuator. `mass`: M.
SmallVector reflected_inertia(const Tangent& tangent, const SmallMatrix& mass);

}  // namespace pmreport::mechanics
