// The plugin's closed form: its overall Jacobian G (6 x 6), G * twist = (actuator rates, 0), and what follows from it.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

struct ClosedForm {
  Matrix6d jacobian, jacobian_rate;  // G and dG/dt along the motion
  double determinant = 0;
  double condition = 0;  // of G made dimensionless by the characteristic length
};
// `length`: characteristic_length(machine) [m].
ClosedForm closed_form(const Machine& machine, const State& state, double length);

// (actuator rates, 0) of a state, and (actuator accelerations, 0).
Vector6d actuator_rates(const State& state);
Vector6d actuator_accelerations(const State& state);

// Twist of the platform from actuator rates, and its rate from their accelerations: A = G^-1 (l'' - G' V).
Vector6d forward_velocity(const ClosedForm& c, const Vector6d& rates);
Vector6d forward_acceleration(const ClosedForm& c, const Vector6d& accelerations, const Vector6d& twist);

// Massless statics: actuator forces (push positive) and constraint wrenches that balance the wrench w on the platform, -G^-T w.
Vector6d closed_statics(const ClosedForm& c, const Vector6d& load);

// The relations that the source states by its matrices (Topology::matrices), with the rates of the state: for each relation, the sum of
// matrices times rates less the rates that they give, relative to the largest term. `matrix`: one of the worst relation.
struct SourceDeviation {
  double value = 0;
  int matrix = -1;  // -1: there is none, or the plugin gives none at this pose and `value` is infinite
};
SourceDeviation source_deviation(const Machine& machine, const State& state);

}  // namespace pmreport::mechanics
