// The generic model: what the declared bodies and joints say, independent of the plugin's closed form.
//
// Each joint between bodies a and b forbids some relative motion at its centre c. With the relative velocity dv = v_b(c) - v_a(c) and the
// relative angular velocity dw = w_b - w_a, a forbidden translation along e reads e . dv = 0 (constraint force along e), a forbidden
// rotation about e reads e . dw = 0 (constraint couple about e):
//   spherical    3 forces                       revolute     3 forces, 2 couples across the axis
//   universal    3 forces, 1 couple a1 x a2     cylindrical  2 forces, 2 couples across the axis
//   prismatic    2 forces across the axis, 3 couples
// The rows stack to PHI (sum of 6 - f rows, 6 n columns), acting on the twists (v of the origin; w) of the bodies 1..n.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

struct GenericModel {
  Eigen::MatrixXd constraints;  // PHI
  Eigen::VectorXd bias;         // PHI' V, so that PHI A + bias = 0 for the true accelerations
  std::vector<int> joint_of_row;
  Eigen::MatrixXd actuation;  // one row an actuator: actuation V = actuator rates
};
GenericModel generic_model(const Machine& machine, const State& state);

// The twists of the bodies 1..n, and their rates, stacked.
Eigen::VectorXd stacked_twists(const State& state);
Eigen::VectorXd stacked_twist_rates(const State& state);

// Mean distance of the platform's joints from its reference point at home [m]: the length that makes moments comparable with forces.
double characteristic_length(const Machine& machine);

// Mobility by rank: 6 n - rank PHI = freedoms + idle, where idle motions move neither platform nor any actuator.
struct Mobility {
  int bodies = 0;  // links, base included
  int joints = 0;
  int freedoms_sum = 0;  // of all joints
  int gruebler = 0;      // 6 (links - joints - 1) + sum f - idle, without redundant constraints
  int rows = 0, rank = 0;
  int idle = 0;       // found by rank
  int freedoms = 0;   // found by rank
  int redundant = 0;  // rows - rank
};
Mobility mobility(const Machine& machine, const State& state);

// Statics of the whole system: PHI^T lambda + B^T tau + w = 0, w the wrenches on the bodies 1..n (force; moment about the body's origin),
// stacked. Least squares; `residual` tells how well equilibrium is met. Redundant constraints give the least-norm lambda.
struct GenericStatics {
  Eigen::VectorXd reactions;        // lambda
  Eigen::VectorXd actuator_forces;  // tau, push positive
  double residual = 0;              // largest unbalanced force or moment, relative to the largest of the loads
};
GenericStatics generic_statics(const GenericModel& model, const Eigen::VectorXd& wrenches);
// Massless: the wrench (force; moment about the reference point) acts on the platform alone.
GenericStatics generic_statics(const Machine& machine, const GenericModel& model, const Vector6d& load);

// The weights of the bodies, as stacked wrenches. `gravity` [m/s^2].
Eigen::VectorXd weights(const Machine& machine, const State& state, const Eigen::Vector3d& gravity);

}  // namespace pmreport::mechanics
