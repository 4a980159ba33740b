// What must hold of the dynamics of every mechanism, as deviations that the property suite judges.
#pragma once

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/reactions/reactions.hpp>

#include <optional>

namespace pmreport::mechanics {

// M = M^T with positive eigenvalues, coordinates in sizes (`length` [m], 1 rad): the larger of the asymmetry and, where a motion has
// kinetic energy zero or less, 1; relative. Zero where no body has mass.
double mass_matrix_deviation(const Machine& machine, const State& state, const Tangent& tangent, double length);

// Energy: d/dt (kinetic + potential) by differences of eighth order along the motion of `state`, against the power of actuators and load.
// Relative to the largest power among them. The step shrinks as `condition` grows, that of the closed form: a motion passes a singular
// pose at a distance of some 1 / condition. Nothing where the edge of reach is too near.
std::optional<double> energy_deviation(const Machine& machine, const State& state, const ForceShares& forces, const Loading& loading,
                                       double condition, double length);

// The free bodies against virtual work, by one dense solution.
struct FreeBodyDeviation {
  double forces = 0;   // actuator forces, relative to the largest
  double balance = 0;  // free_body_residual
  double stress = 0;   // the same of every self-stress, which has to balance without any load
  int stresses = 0;    // how many there are
};
FreeBodyDeviation free_body_deviation(const Machine& machine, const State& state, const JointFrames& frames, const ForceShares& forces,
                                      const Loading& loading, double length);

}  // namespace pmreport::mechanics
