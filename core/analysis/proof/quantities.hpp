// What is followed of a motion: quantities with their rates, and where each is in the program that bounds them.
#pragma once

#include <core/analysis/column_names.hpp>
#include <core/mechanics/recorded/motion_program.hpp>

#include <string>
#include <vector>

namespace pmreport::analysis {

// A quantity of the machine in time. Numbers of quantities are places in Quantities::all.
struct Quantity {
  enum class Of { reach, coordinate, derived, actuator, joint } of = Of::reach;
  int index = 0, part = 0;           // which of them; of a joint: which limit
  OfMotion order = OfMotion::value;  // of coordinates and actuators all three are followed, of derived quantities two
  std::size_t output = 0;            // of the mechanism's program: the value that this is, or is the rate or acceleration of
};

struct Quantities {
  explicit Quantities(const mechanics::Machine& machine, const mechanics::MotionProgram& program);

  std::vector<Quantity> all;  // the reach first
  std::vector<int> actuators,
      joints;  // numbers of the values of actuators, in order; of the motions of joints, as in MotionProgram::joints

  // The name of its column; the reach has none.
  ColumnId column(const mechanics::Machine& machine, const Quantity& q) const;
};

}  // namespace pmreport::analysis
