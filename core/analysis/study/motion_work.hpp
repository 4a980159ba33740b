// What flows along a motion: the work of actuators and load against the energy of all bodies.
#pragma once

#include <core/analysis/analysis.hpp>

#include <optional>
#include <vector>

namespace pmreport::analysis {

struct MotionWork {
  std::vector<double> actuators;    // work of each [J]
  std::vector<double> regenerated;  // of it, what its load and inertia gave back: the integral of negative power, as a positive number [J]
  double load = 0;                  // work of the load [J]
  double stored = 0;                // kinetic and potential energy at the end less those at the start [J]
  double flow = 0;                  // what passed actuators and load and went in and out of store: the scale of the others [J]
  // How far the sums may be off: by what two rules of integration differ, and by the rounding of powers, energies and times [J].
  double uncertainty = 0;
  double regenerated_uncertainty = 0;  // of `regenerated`, which has kinks of its own, all together [J]
  bool whole = true;                   // every sample has a pose; else the runs of samples that have one are summed
  bool closed = false;                 // the motion ends in the pose and with the rates of its start

  double work() const;  // of all actuators [J]
};
// Nothing where the motion meets a singular surface, which takes boundless forces, or has no two neighbouring samples with a pose.
std::optional<MotionWork> motion_work(const Analysis& a);

}  // namespace pmreport::analysis
