// What the moving bodies demand: rates of momentum, and energies.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

// What must act on each of the bodies 1..n for it to move as it does, stacked as wrenches (force; moment about the body's origin), base
// axes: with the centre of mass at c = R c_body from the origin, m a_c and c x m a_c + I e + w x I w.
Eigen::VectorXd inertial_wrenches(const Machine& machine, const State& state);

// The load, one wrench (force; moment about the platform's reference point), and the weights in a uniform field of gravity.
struct Loading {
  Vector6d platform = Vector6d::Zero();               // [N], [N m]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s^2]
};
// As wrenches on the bodies 1..n, stacked likewise.
Eigen::VectorXd applied_wrenches(const Machine& machine, const State& state, const Loading& loading);

double kinetic_energy(const Machine& machine, const State& state);                                    // [J]
double potential_energy(const Machine& machine, const State& state, const Eigen::Vector3d& gravity);  // [J], zero at the base's origin

// Mass matrix of one body about its origin (6 x 6): (force; moment) = M (acceleration; angular acceleration) + terms of the rates.
Matrix6d mass_matrix(const Inertia& inertia, const BodyState& body);

}  // namespace pmreport::mechanics
