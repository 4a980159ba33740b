// A mechanism in motion: where every body is, its twist and its acceleration, from the second-order jets of `place`.
//
// Names, here and in all of core/mechanics. Vectors are in base axes, unless said otherwise.
//     p_AB       position of point B from point A [m]; p_B from the base's origin. A body's letter stands for its origin, O for the
//                platform's reference point, C for the centre of a joint or of mass
//     p_AB_A     the same in the axes of body A
//     R_A        rotation of body A: its columns are the axes of A; v = R_A v_A takes a vector from the axes of A to those of the base
//     R_AB       R_A^T R_B, rotation of B as seen in A
//     v_A, w_A   velocity of A's origin [m/s] and angular velocity [rad/s], together the twist V_A = (v_A; w_A)
//     a_A, e_A   their rates [m/s^2], [rad/s^2]
//     W          a wrench (force [N]; moment [N m]), about the origin of the body that it acts on: its power is W . V
#pragma once

#include <core/linear/types.hpp>
#include <core/mechanics/machine/machine.hpp>

#include <string>
#include <vector>

namespace pmreport::mechanics {

using linear::Matrix6d, linear::SmallMatrix, linear::SmallVector, linear::Vector6d;

struct BodyState {                                         // of body A, in base axes
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();        // p_A [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // R_A; of a slender body: z along its axis, the others anyhow
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), angular_velocity = Eigen::Vector3d::Zero();          // v_A, w_A
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero(), angular_acceleration = Eigen::Vector3d::Zero();  // a_A, e_A

  Vector6d twist() const { return (Vector6d() << velocity, angular_velocity).finished(); }
  Vector6d twist_rate() const { return (Vector6d() << acceleration, angular_acceleration).finished(); }
};

struct JointState {                                  // as the plugin places it, base axes
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // p_C [m]
  Eigen::Vector3d axis[2] = {                        // unit vectors, as many as the kind of joint has; else zero
      Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

struct Scalar {  // a quantity with its time derivatives: [m] or [rad], a second, a second squared
  double value = 0, rate = 0, acceleration = 0;
};

struct State {
  pm_status status = PM_FAILED;  // PM_OK; PM_UNREACHABLE; PM_SINGULAR: no finite numbers, or rates, there; PM_FAILED
  std::string why;               // a sentence when not PM_OK; then nothing below but the coordinates is to be read
  std::vector<Scalar> coordinates, actuators, derived;
  std::vector<BodyState> bodies;  // base first
  std::vector<JointState> joints;
  std::vector<double> coordinate_jets, placement_jets;  // as the contract has them, for further calls
};

// The state at coordinates q [m], [rad] with rates and accelerations, each dof numbers. Failure is told by `out.status`; nothing is thrown.
// Reuses the memory of `out`.
void evaluate(const Machine& machine, const double* q, const double* q_rate, const double* q_acceleration, State& out);

// The state at rest, at dof coordinates [m], [rad]. Failure is told by its status.
State state_at_rest(const Machine& machine, const Eigen::VectorXd& coordinates);

}  // namespace pmreport::mechanics
