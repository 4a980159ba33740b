// The motion that a scenario asks for. What follows from it is a trajectory.
#pragma once

#include <core/mechanics/model/state.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <functional>
#include <string>
#include <vector>

namespace pmreport::scenario {

// Forces of the actuators [N], [N m] at a time [s], given their values and rates as they are then; dof long, push positive.
using ActuatorForces = std::function<void(double t, const std::vector<mechanics::Scalar>& actuators, double* forces)>;

// A scenario prescribes the independent coordinates against time, with exact first and second derivatives; or the actuators, and the
// coordinates follow by forward displacement from home; or the forces of the actuators, and they follow by forward dynamics.
struct MotionRequest {
  enum class By { coordinates, actuators, forces } by = By::coordinates;
  mechanics::Path prescribed;      // of the coordinates, or of the actuators; none by forces
  mechanics::Enclosure over;       // the same over spans of time; none by forces
  std::vector<double> steps;       // rising: between two neighbours a handful of points show all that it does; none by forces
  ActuatorForces forces;           // by forces
  double end = 0;                  // when the motion should end [s]
  bool until_singularity = false;  // it may end before, at a singular surface (or, by forces, at a limit)
  std::string description;         // one line a prescribed quantity, for the report: "x = 20 mm * sin(2*pi*t/10 s)"

  bool by_actuators() const { return by == By::actuators; }
  bool by_forces() const { return by == By::forces; }
};

// Times of a motion; empty: there is none.
struct TimeSpan {
  double begin = 0, end = 0;  // [s]
  bool empty() const { return end < begin; }
};

}  // namespace pmreport::scenario
