// What the columns are called: the one place that knows. The lists of columns.hpp are made of these names, and whoever fills or reads a
// column asks for it by what it belongs to.
#pragma once

#include <core/scenario/section/kind.hpp>
#include <pmreport/topology.hpp>

#include <compare>
#include <cstddef>
#include <string>
#include <utility>

namespace pmreport::analysis {

using scenario::Column;

// A handle of a column. A text alone does not make one, so that a misspelt name cannot be asked for.
class ColumnId {
 public:
  ColumnId(const Column& column) : name_(column.name) {}                         // of a list
  static ColumnId named(std::string name) { return ColumnId(std::move(name)); }  // as a user wrote it; there need be no such column
  const std::string& name() const { return name_; }                              // as checks and data files call it: "l1_rate"
  friend auto operator<=>(const ColumnId&, const ColumnId&) = default;           // by name

 private:
  explicit ColumnId(std::string name) : name_(std::move(name)) {}
  std::string name_;
};

enum class OfMotion { value, rate, acceleration };
enum class OfActuator {
  static_force,   // at rest
  dynamic_force,  // in motion, and what it sums up: the shares of load, weights and inertia
  load_force,
  gravity_force,
  inertia_force,
  power,
  drive_force,
  drive_power,
  motor_torque,
  motor_speed,
  motor_power,
  reflected_inertia,
  pressure,  // of transmission
  output,
  input
};
enum class OfJoint { force, moment };  // their sizes
enum class OfPlatform { velocity, angular_velocity, acceleration, angular_acceleration, deflection, deflection_turn };
enum class OfElement { axial, bending, torque, buckling, share };
enum class OfStiffness {
  deflection_size,  // of the tool, and of its parts
  load_deflection,
  weight_deflection,
  inertia_deflection,
  pF_max,
  pF_min,
  pT_max,
  pT_min,
  PhiT_max,
  PhiT_min
};
enum class OfMachine {
  determinant,
  condition,
  total_power,
  load_power,
  kinetic_energy,
  potential_energy,
  local_transmission,
  least_cosine,
  local_conditioning,
  manipulability
};

// What stands behind the name of its actuator, and names the group of all actuators too: "motor_torque".
std::string word_of(OfActuator what);
// Of a vector: "angular_velocity"; its group is called alike.
std::string word_of(OfPlatform vector);
std::string word_of(OfElement what);
// The group of what moves, of the kind "coordinate", "derived" or "actuator": its values "actuator", its rates "actuator_rate".
std::string group_of(const std::string& kind, OfMotion what);

ColumnId column_of(const Coordinate& coordinate, OfMotion what = OfMotion::value);  // "x", "x_rate", "x_acceleration"
ColumnId column_of(const Derived& derived, OfMotion what = OfMotion::value);
ColumnId column_of(const Actuator& actuator, OfMotion what = OfMotion::value);
ColumnId column_of(const Actuator& actuator, OfActuator what);  // "l1_force", "l1_dynamic_force"
ColumnId column_of(const Reading& reading);
ColumnId column_of(const Constraint& constraint);
ColumnId transmission_of(const Constraint& constraint);      // "constraint1_transmission"
ColumnId column_of(const Joint& joint, OfJoint what);        // "B1_force"
ColumnId column_of(OfPlatform vector, std::size_t axis);     // "velocity_x"; `axis`: of the base, 0-2
ColumnId column_of(OfMachine what);                          // "det_G", "total_power"
ColumnId column_of(const Element& element, OfElement what);  // "leg1_axial"
ColumnId column_of(OfStiffness what);                        // "pF_max"
ColumnId frequency_column(int mode);                         // from 1: "frequency1"

// Of limit number `limit` of a joint: "A1_deflection", "B5_angle", "U1_angle2".
ColumnId joint_column(const Joint& joint, std::size_t limit);
// Of component c of the wrench in a joint: "B1_force_1", "B1_moment_3" in joint axes, "B1_force_x" in base axes.
ColumnId reaction_column(const Joint& joint, int c, bool base_axes);
// Of component c of the wrench of a limb, from 1, on the platform: "limb2_moment_x".
ColumnId limb_column(int limb, int c);

// The name of what a column belongs to, which labels its curve: "l1" of "l1_rate", "B5" of "B5_angle".
std::string owner_of(const ColumnId& column);
// Whether it is one of an actuator's motor, which only an actuator whose motor is described has.
bool of_motor(const Actuator& actuator, const ColumnId& column);

}  // namespace pmreport::analysis
