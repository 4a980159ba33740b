// A motion between its samples: the state at any time, the powers of actuators and load, and the energy of all bodies.
#pragma once

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/load.hpp>

#include <vector>

namespace pmreport::analysis {

// Keeps buffers: one object a thread.
class MotionProbe {
 public:
  MotionProbe(const mechanics::Trajectory& trajectory, const scenario::Load& load, const mechanics::Machine& m)
      : trajectory_(trajectory), load_(load), machine_(m), value_(m.dof()), rate_(m.dof()), acceleration_(m.dof()) {}

  bool go(double t);  // false where the motion has no pose
  const mechanics::State& state() const { return state_; }

  // Where it went last.
  double energy() const;                        // kinetic and potential [J]
  void powers(std::vector<double>& out) const;  // of each actuator, then of the load [W]

 private:
  const mechanics::Trajectory& trajectory_;
  const scenario::Load& load_;
  const mechanics::Machine& machine_;
  mechanics::SmallVector value_, rate_, acceleration_;
  double time_ = 0;
  mechanics::State state_;
};

}  // namespace pmreport::analysis
