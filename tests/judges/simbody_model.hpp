// A mechanism as Simbody sees it (Sherman, Seth, Delp: Simbody: multibody dynamics for biomedical research, 2011).
//
// It is built from the declared bodies, joints and inertias and the home placement alone. Nothing of the generic model, of the partials or
// of the closed forms goes into it. Simbody works in joint coordinates: a spanning tree of mobilizers reaches every body from the base, the
// joints left over are constraints. The actuated joints are in the tree, and their accelerations are prescribed; Simbody finds those of
// everything else by its articulated bodies and Lagrange multipliers, and the forces that the prescribed motions take.
#pragma once

#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/model/state.hpp>

#include <memory>
#include <vector>

namespace pmreport::judges {

class SimbodyModel {
 public:
  // Throws std::invalid_argument for what it cannot express: an actuated joint of more than one freedom, or actuated joints in a loop.
  explicit SimbodyModel(const mechanics::Machine& machine);
  ~SimbodyModel();

  // A state in Simbody's own terms.
  struct Input {
    std::vector<double> coordinates, speeds;  // of the mobilizers
    std::vector<double> accelerations;        // of the actuators [m/s^2], [rad/s^2]
    mechanics::Vector6d load;                 // on the platform (force; moment about its reference point) [N], [N m]
  };
  Input input(const mechanics::State& state, const mechanics::Vector6d& load) const;

  void set_gravity(const Eigen::Vector3d& gravity);  // [m/s^2]

  // Accelerations, and with them all forces, at `input`.
  void solve(const Input& input);

  // What follows is at the input solved last.

  // By how much Simbody's constraints are violated, and its bodies differ from those of `state`, at worst: lengths [m], [m/s], [m/s^2],
  // rotations likewise in radians, and of the spin of slender bodies no position. Angular accelerations count by what they are at the
  // characteristic length, [m/s^2]: Simbody finds them from how far apart the joints of a body accelerate.
  struct Deviation {
    double position = 0, velocity = 0, acceleration = 0;
  };
  Deviation deviation(const mechanics::State& state) const;

  std::vector<double> actuator_forces() const;  // push positive [N], [N m]

  // What body a of each joint exerts on body b: (force; moment about the centre that `state` gives the joint), base axes, without what the
  // actuator exerts.
  std::vector<mechanics::Vector6d> joint_reactions(const mechanics::State& state) const;

  // As Simbody itself gives the reactions, mobilizer by mobilizer; a number that depends on them. For measuring what it takes.
  double mobilizer_reactions() const;

  int constraint_equations() const;
  int redundant_constraints() const;  // of these, by rank: as many self-stresses as the mechanism has

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pmreport::judges
