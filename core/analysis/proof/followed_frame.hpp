// The path that coordinates take with their actuators, near an instant and in plain numbers: what interval Newton starts from. Nothing
// that is proved rests on its accuracy.
//
// With l(q) the actuators of the recorded geometry, l*(t) those prescribed and J = dl/dq, Newton's method gives q at an instant c,
//     q <- q + J^-1 (l*(c) - l(q)),
// and v = J^-1 l*'(c) the rates there. The frame moves with these: its origin is at q + v (t - c).
#pragma once

#include <core/linear/types.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/program/evaluate.hpp>
#include <core/program/program.hpp>

#include <optional>
#include <vector>

namespace pmreport::analysis {

using linear::SmallMatrix, linear::SmallVector;

// The actuators l of a geometry, alone. What is continuous has a mean value theorem, and a choice between two formulas may not be, nor
// atan2 where it goes round: after the actuators the programs give 1 or 0 for each, so that a box on which it is open is known; then the
// same for each kink: where the smaller, the larger or the absolute value, which are continuous, go over from one side to the other, and J
// jumps.
struct ActuatorGeometry {
  // `first`: the output that is the first actuator.
  ActuatorGeometry(const program::Program& geometry, std::size_t first);

  int dof, choices = 0, kinks = 0;
  program::Program values;    // l; choices; kinks
  program::Program partials;  // the same; then J by rows; then zeros
  program::Program in_time;   // of order 2 (derivative.hpp)
  program::Program turning;   // of coordinates and their rates: choices; kinks; then J' by rows

  std::size_t outputs() const { return static_cast<std::size_t>(dof + choices + kinks); }
};

struct MovingFrame {
  double middle = 0;             // c [s]
  SmallVector origin, velocity;  // at c
  SmallMatrix inverse;           // J^-1 at the origin, nearly
};

class FrameFinder {
 public:
  // `sizes`: of the coordinates, to measure by. Both must outlive it. Keeps its buffers: one a thread.
  FrameFinder(const ActuatorGeometry& geometry, const SmallVector& sizes);

  // At time `t`, at which the actuators are `prescribed`, dof of them, from coordinates nearby. Nothing where Newton's method leads to no
  // pose nearby.
  std::optional<MovingFrame> at(double t, const mechanics::Bounded* prescribed, SmallVector nearby);

  // How far coordinates are from where the actuators are `prescribed`, nearly, in sizes.
  double deviation(const MovingFrame& frame, const SmallVector& coordinates, const mechanics::Bounded* prescribed);

 private:
  const ActuatorGeometry& geometry_;
  const SmallVector& sizes_;
  program::Evaluator<double> values_, partials_;
  std::vector<double> out_;
};

}  // namespace pmreport::analysis
