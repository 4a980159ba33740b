// The plugin's closed form: its overall Jacobian G (6 x 6), and what follows from it. With V = (v; w) the twist of the platform about its
// reference point and l the actuators,
//     G V = (l', 0)                          (1)
//     G V' + G' V = (l'', 0)                 (2)
// The rows below the actuators' are the constraint wrenches of the limbs: those do no work on any motion of the platform.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

struct ClosedForm {
  Matrix6d jacobian, jacobian_rate;  // G and G' along the motion
  double determinant = 0;            // of G, in its own units
  int side = 0;                      // its sign, 0 where rounding could turn it over (overall_jacobian.hpp)
  double condition = 0;              // of G^, 1 at best; infinite where G is singular
  double wrench_determinant = 0;     // of the unit wrenches G_
  double wrench_condition = 0;       // of these: what a solution by G loses, whatever the levers of the actuators
  double amplification = 0;          // of these: the largest sum of squares, as a root, that a load of unit size asks of them
};
// Of an assembled pose: `state.status` is PM_OK. `length`: characteristic_length(machine) [m]. Where the plugin gives no G the numbers are
// not finite, and the side is 0.
ClosedForm closed_form(const Machine& machine, const State& state, double length);

// The right sides of (1) and (2): (actuator rates, 0) of a state, and (actuator accelerations, 0).
Vector6d actuator_rates(const State& state);
Vector6d actuator_accelerations(const State& state);

// Twist of the platform from (actuator rates, 0), V = G^-1 l', and its rate from (actuator accelerations, 0), V' = G^-1 (l'' - G' V). Not
// finite, or large, where G is singular.
Vector6d forward_velocity(const ClosedForm& c, const Vector6d& rates);
Vector6d forward_acceleration(const ClosedForm& c, const Vector6d& accelerations, const Vector6d& twist);

// The relations that the source states by its matrices (Topology::matrices), with the rates of the state: for each relation, the sum of
// matrices times rates less the rates that they give, relative to the largest term. `matrix`: one of the worst relation.
struct SourceDeviation {
  double value = 0;
  int matrix = -1;  // -1: there is none, or the plugin gives none at this pose and `value` is infinite
};
SourceDeviation source_deviation(const Machine& machine, const State& state);

}  // namespace pmreport::mechanics
