// Where a motion meets a singularity: between samples, by bisection in time, and by proof.
#pragma once

#include <core/analysis/conditioning.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/program/intervals/bounds.hpp>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace pmreport::analysis {

struct Crossing {
  enum class What {
    surface,      // det G is zero: the actuators do not hold the platform
    pole,         // det G passes through infinity: a limb holds the platform whatever its actuator does
    bodies,       // det G is regular, and yet bodies move with all actuators locked
    freedoms,     // the platform gains a freedom that no actuator has a say in (constraint singularity)
    limb,         // with the platform locked an actuator moves (type 1)
    limb_locked,  // bodies of a limb move by themselves, platform and actuators locked
  };
  int before = 0;               // sample at or before it
  double time = 0;              // [s], to the last digits of a double; where it lasts, when it begins
  double until = 0;             // [s]; `time`, or when it ends
  Eigen::VectorXd coordinates;  // there
  What what = What::surface;
  bool touches = false;  // it comes back on the same side, or ends, or begins, there; of `bodies` and below: nothing tells the sides apart
  std::optional<program::Bounds> proved = {};  // it happens within [s]; none: it was not proved
  bool unseen = false;                         // the samples do not show it, the proof does

  bool lasts() const { return until > time; }
};

// Those that the wrenches on the platform tell: the motion changes its side of a singular surface, touches it, or stays on it. `wrenches`:
// of every sample. `length`: characteristic length of the machine [m].
std::vector<Crossing> find_crossings(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
                                     const std::vector<HoldingWrenches>& wrenches, double length);

}  // namespace pmreport::analysis
