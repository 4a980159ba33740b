// Poses with given actuator values that a plugin's `place` cannot express: a platform with fewer coordinates than six may stand otherwise
// than they say, and limbs in ways that no working mode has.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>

#include <vector>

namespace pmreport::mechanics {

struct FurtherPose {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // of the platform [m]
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  double distance = 0;   // from the reference pose [m]
  double error = 0;      // largest of the loop equations, lengths by the characteristic length
  bool isolated = true;  // else the platform moves with its actuators held
};

struct FurtherModes {
  std::vector<FurtherPose> poses;  // one for each place of the platform, nearest to the reference first
  int starts = 0, arrivals = 0;    // of Newton's method, and how many closed all joints
  int missed = 0;                  // arrivals at a mode that `place` can express and the search before had not found
};

// Newton's method on the loop equations of all bodies, by steps of least norm, which leaves idle spins alone. It starts from the modes
// found, the platform moved and turned at random, all bodies between base and platform by their share of the way. `found` has the modes of
// all working modes. The same numbers on every run. No number of starts proves that there are no more.
FurtherModes find_further_modes(const Machine& machine, const Eigen::VectorXd& actuators, const Eigen::VectorXd& reference,
                                const AssemblyModes& found, int starts = 60);

}  // namespace pmreport::mechanics
