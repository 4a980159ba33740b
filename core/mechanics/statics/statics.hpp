// Equilibrium at rest: actuator forces and reactions that balance given wrenches, by the plugin's closed form and by the generic model.
//
// A wrench is (force; moment) [N, N m], forces of actuators push positive: they extend a linear one, or turn a rotary one its positive way.
#pragma once

#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>

namespace pmreport::mechanics {

// Massless, by G of the platform alone. For every twist V of the platform the powers vanish together, tau . (G V) + w . V = 0, hence
//     tau = -G^-T w                                                         (1)
// `load`: w, about the platform's reference point. Actuator forces first, then the constraint wrenches, in the order of the rows of G. Not
// finite, or large, where G is singular.
Vector6d closed_statics(const ClosedForm& c, const Vector6d& load);

// Of the whole system, by virtual power of all bodies: with V their stacked twists and B V the actuator rates,
//     PHI^T lambda + B^T tau + w = 0                                        (2)
// 6 n equations. Where they leave lambda open (redundant constraints, or actuators against them) the answer is the one of least norm; where
// they cannot be met (a singular pose) it is the one that comes nearest, and `residual` tells.
struct GenericStatics {
  Eigen::VectorXd reactions;        // lambda, one a row of PHI: [N], or [N m] of a couple
  Eigen::VectorXd actuator_forces;  // tau [N], [N m]
  double residual = 0;              // largest number left over in (2), relative to the largest in w; 0 without a load
};
// `wrenches`: w on the bodies 1..n, each about the origin of its body, 6 n numbers.
GenericStatics generic_statics(const GenericModel& model, const Eigen::VectorXd& wrenches);
// Massless: `load` acts on the platform alone, about its reference point.
GenericStatics generic_statics(const Machine& machine, const GenericModel& model, const Vector6d& load);

// The weights of the bodies 1..n in a uniform field, each about the origin of its body, stacked, 6 n numbers. With c the centre of mass
// from the origin: (m g; c x m g). `gravity` [m/s^2].
Eigen::VectorXd weights(const Machine& machine, const State& state, const Eigen::Vector3d& gravity);

}  // namespace pmreport::mechanics
