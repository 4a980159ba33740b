// What must hold of the rows of the overall Jacobian below the actuators', the constraint wrenches. Those of the actuators are held by
// their rates; what does no work on any motion may be twice as large, or zero, and no rate tells.
#pragma once

#include <core/mechanics/model/generic_model.hpp>

namespace pmreport::mechanics {

// Of a constraint in N the force of its row has length 1, of one in N m the moment about the reference point. How far the worst is from
// that; `row` of G, -1: there is none.
struct WrenchDeviation {
  double value = 0;
  int row = -1;
};
WrenchDeviation unit_deviation(const Machine& machine, const Matrix6d& jacobian);

// The limb that the title of a constraint names, "force of limb 2 along its hinge"; 0: none, or several.
int limb_named(const Constraint& constraint);

// A constraint that names a limb does no work on any motion that this limb, left alone, allows the platform. The largest sine of an angle
// between a row and the wrenches of its limb; rows of limbs that reach the platform only with others are left out.
WrenchDeviation limb_deviation(const Machine& machine, const State& state, const GenericModel& model, const Matrix6d& jacobian);

}  // namespace pmreport::mechanics
