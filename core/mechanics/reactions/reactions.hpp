// The reaction of every joint, by Newton and Euler on every body, and whether it is the only one.
//
//     PHI^T lambda + B^T tau + applied = inertial           (1)
// with the rows of generic_model.hpp and the wrenches of momentum.hpp is one linear system over all bodies 1..n for the constraint
// reactions lambda and the actuator forces tau. Its null space is the self-stress: reactions that balance one another without any load. A
// component of a reaction that vanishes in all of it is unique. Any other is indeterminate: rigid bodies do not tell it, stiffness or play
// would, and what is given is the least-norm one: the least sum over the joints of |force|^2 + |moment / length|^2, length the
// characteristic length.
#pragma once

#include <core/linear/least_norm.hpp>
#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/joint_frame.hpp>

#include <cstdint>

namespace pmreport::mechanics {

// Bit c of an Indeterminate: component c of a joint's wrench, 0-2 force, 3-5 moment, in joint axes; bit 6 + c: in base axes.
using Indeterminate = std::uint16_t;

struct JointReactions {
  Eigen::VectorXd actuator_forces;  // tau, push positive [N] or [N m]; not part of the reactions below
  std::vector<Vector6d> joints;     // what body a of each joint exerts on body b: (force; moment about the joint's centre), base axes
  std::vector<Indeterminate> indeterminate;
  std::vector<std::vector<Vector6d>> stresses;  // independent self-stresses, each as `joints`, in no particular scale
  double residual = 0;    // free bodies: largest unbalanced force, or moment per length, relative to the largest reaction, load or inertia
  bool singular = false;  // the actuators cannot carry every load here: no forces are given
};

// The system (1) at a pose, factorised over all bodies at once. `state.status` is PM_OK and `model` its generic model; machine, state,
// model and frames must outlive it. `length`: characteristic_length(machine) [m].
class DenseSystem {
 public:
  DenseSystem(const Machine& machine, const State& state, const GenericModel& model, const JointFrames& frames, double length);

  // `required`: inertial less applied wrenches of the bodies 1..n, stacked, each about the body's origin.
  JointReactions reactions(const Eigen::VectorXd& required) const;

 private:
  const Machine& machine_;
  const State& state_;
  const GenericModel& model_;
  double length_;
  Eigen::VectorXd scale_;
  linear::LeastNorm solver_;
  JointReactions stresses_;  // without loads: what the null space says
};

// By one dense factorisation over all bodies: for any structure, and the judge of InverseDynamics.
// `state.status` is PM_OK; `model` is its generic model; `length`: characteristic_length(machine) [m].
JointReactions dense_reactions(const Machine& machine, const State& state, const GenericModel& model, const JointFrames& frames,
                               const Loading& loading, double length);

// A wrench (force; moment) in base axes by its components along the columns of `frame`.
Vector6d in_axes(const Eigen::Matrix3d& frame, const Vector6d& wrench);

// Which components of the joints' wrenches `stresses` reach: those above 1e-7 of the largest force, or moment per length, in that stress.
std::vector<Indeterminate> indeterminate_components(const State& state, const JointFrames& frames,
                                                    const std::vector<std::vector<Vector6d>>& stresses, double length);

// Largest unbalanced force, or moment per length, of any of the bodies 1..n under the reactions, the actuator forces, and `required`, the
// inertial less the applied wrenches, stacked; relative to the largest of them. It follows each wrench from joint to body anew, and knows
// nothing of how the reactions were found.
double free_body_residual(const Machine& machine, const State& state, const std::vector<Vector6d>& joints,
                          const Eigen::VectorXd& actuator_forces, const Eigen::VectorXd& required, double length);

// The wrench (force; moment about the platform's reference point) that the joints of each limb exert on the platform, drives included; by
// limb number, limb 1 first.
std::vector<Vector6d> limb_wrenches(const Machine& machine, const State& state, const JointReactions& reactions);

}  // namespace pmreport::mechanics
