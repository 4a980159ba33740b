// The generic model: what the declared bodies and joints say, independent of the plugin's closed form.
//
// Each joint between bodies A and B forbids some relative motion at its centre C. With the names of state.hpp the relative motion is
//     v = (v_B + w_B x p_BC) - (v_A + w_A x p_AC),   w = w_B - w_A              (1)
// A forbidden translation along e, and a forbidden rotation about e, read
//     e . v = 0,   on the twist (v_B; w_B) the row (e; p_BC x e), on A its negative with p_AC: a constraint force along e   (2)
//     e . w = 0,   on B the row (0; e), on A its negative: a constraint couple about e                                     (3)
// because e . (w_B x p_BC) = w_B . (p_BC x e). The kinds of joints forbid
//   spherical    3 forces                       revolute     3 forces, 2 couples across the axis
//   universal    3 forces, 1 couple a1 x a2     cylindrical  2 forces, 2 couples across the axis
//   prismatic    2 forces across the axis, 3 couples
// The rows stack to PHI (sum of 6 - f rows, 6 n columns), acting on the twists of the bodies 1..n: PHI V = 0.
//
// Along a motion e turns and C moves with the body that carries them, and d/dt (2), d/dt (3) are
//     e . (a_B + e_B x p_BC + w_B x (v_C - v_B) - a_A - e_A x p_AC - w_A x (v_C - v_A)) + e' . v = 0        (4)
//     e . (e_B - e_A) + e' . w = 0                                                                       (5)
// in which what the accelerations do not enter is the bias: PHI A + bias = 0. In (4) v_C may be the velocity of any point that stays at the
// centre; that of the point of A is taken.
//
// An actuator measures along, or about, axis 1 of its joint, n: its rate is n . v, or n . w, and its row of B is (2) or (3) with n for e.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

struct GenericModel {
  Eigen::MatrixXd constraints;    // PHI: rows [1] and [m] on (velocity; angular velocity), force rows of a joint before its couples
  Eigen::VectorXd bias;           // one number a row of PHI [m/s^2], [rad/s^2]
  std::vector<int> joint_of_row;  // of PHI
  Eigen::MatrixXd actuation;      // B: one row an actuator, 6 n columns
};
// Of an assembled pose: `state.status` is PM_OK.
GenericModel generic_model(const Machine& machine, const State& state);

// The twists of the bodies 1..n, and their rates, stacked: 6 n numbers.
Eigen::VectorXd stacked_twists(const State& state);
Eigen::VectorXd stacked_twist_rates(const State& state);

// Mean distance of the centres of the platform's joints from its reference point at home [m], 1 m where all are in that point: the length
// that makes moments comparable with forces, and rotations with translations. Above zero.
double characteristic_length(const Machine& machine);

}  // namespace pmreport::mechanics
