// What the moving bodies demand: rates of momentum, and energies.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

// Of body A with the centre of mass C, p_AC = R_A p_AC_A, mass m and inertia about C in base axes I = R_A I_A R_A^T (names of state.hpp):
//     a_C = a_A + e_A x p_AC + w_A x (w_A x p_AC)                               (1)
//     force m a_C,   moment about A's origin p_AC x m a_C + I e_A + w_A x I w_A   (2)
// What must act on each of the bodies 1..n for it to move as it does: (2), stacked as wrenches, 6 n numbers. `state.status` is PM_OK.
Eigen::VectorXd inertial_wrenches(const Machine& machine, const State& state);

// The load, one wrench (force; moment about the platform's reference point), and the weights in a uniform field of gravity.
struct Loading {
  Vector6d platform = Vector6d::Zero();               // [N], [N m]
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  // [m/s^2]
};
// As wrenches on the bodies 1..n, stacked likewise: (m g; p_AC x m g), and the load on the platform.
Eigen::VectorXd applied_wrenches(const Machine& machine, const State& state, const Loading& loading);

// Sums over the bodies of m v_C^2 / 2 + w . I w / 2, v_C = v_A + w_A x p_AC, and of -m g . p_C: zero at the base's origin [J].
double kinetic_energy(const Machine& machine, const State& state);
double potential_energy(const Machine& machine, const State& state, const Eigen::Vector3d& gravity);

// Mass matrix of one body about its origin: (2) is M (a_A; e_A) + terms of w_A. With [c] the matrix of c x, c = p_AC,
//     M = | m 1      -m [c]         |
//         | m [c]    I - m [c] [c]  |                                           (3)
// symmetric, in [kg], [kg m], [kg m^2]; kinetic energy V . M V / 2.
Matrix6d mass_matrix(const Inertia& inertia, const BodyState& body);

}  // namespace pmreport::mechanics
