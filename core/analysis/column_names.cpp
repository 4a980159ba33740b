#include <core/analysis/column_names.hpp>

#include <core/mechanics/machine/joint_words.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::analysis {

namespace {

// Of a joint's motion.
constexpr const char *deflection = "_deflection", *angle = "_angle";
// Of a constraint's.
constexpr const char* transmission = "_transmission";

std::string suffix_of(OfMotion what) {
  switch (what) {
    case OfMotion::value:
      return "";
    case OfMotion::rate:
      return "_rate";
    case OfMotion::acceleration:
      return "_acceleration";
  }
  return "";
}

std::string suffix_of(OfActuator what) { return "_" + word_of(what); }

std::string suffix_of(OfJoint what) { return what == OfJoint::force ? "_force" : "_moment"; }

const char* name_of(OfMachine what) {
  switch (what) {
    case OfMachine::determinant:
      return "det_G";
    case OfMachine::condition:
      return "condition";
    case OfMachine::total_power:
      return "total_power";
    case OfMachine::load_power:
      return "load_power";
    case OfMachine::kinetic_energy:
      return "kinetic_energy";
    case OfMachine::potential_energy:
      return "potential_energy";
    case OfMachine::local_transmission:
      return "local_transmission";
    case OfMachine::least_cosine:
      return "least_cosine";
    case OfMachine::local_conditioning:
      return "local_conditioning";
    case OfMachine::manipulability:
      return "manipulability";
  }
  return "";
}

const char* name_of(OfStiffness what) {
  switch (what) {
    case OfStiffness::deflection_size:
      return "deflection_size";
    case OfStiffness::load_deflection:
      return "load_deflection";
    case OfStiffness::weight_deflection:
      return "weight_deflection";
    case OfStiffness::inertia_deflection:
      return "inertia_deflection";
    case OfStiffness::pF_max:
      return "pF_max";
    case OfStiffness::pF_min:
      return "pF_min";
    case OfStiffness::pT_max:
      return "pT_max";
    case OfStiffness::pT_min:
      return "pT_min";
    case OfStiffness::PhiT_max:
      return "PhiT_max";
    case OfStiffness::PhiT_min:
      return "PhiT_min";
  }
  return "";
}

OfJoint part_of(int c) { return c < 3 ? OfJoint::force : OfJoint::moment; }

}  // namespace

std::string word_of(OfActuator what) {
  switch (what) {
    case OfActuator::static_force:
      return "force";
    case OfActuator::dynamic_force:
      return "dynamic_force";
    case OfActuator::load_force:
      return "load_force";
    case OfActuator::gravity_force:
      return "gravity_force";
    case OfActuator::inertia_force:
      return "inertia_force";
    case OfActuator::power:
      return "power";
    case OfActuator::drive_force:
      return "drive_force";
    case OfActuator::drive_power:
      return "drive_power";
    case OfActuator::motor_torque:
      return "motor_torque";
    case OfActuator::motor_speed:
      return "motor_speed";
    case OfActuator::motor_power:
      return "motor_power";
    case OfActuator::reflected_inertia:
      return "reflected_inertia";
    case OfActuator::pressure:
      return "pressure";
    case OfActuator::output:
      return "output";
    case OfActuator::input:
      return "input";
  }
  return "";
}

std::string word_of(OfPlatform vector) {
  switch (vector) {
    case OfPlatform::velocity:
      return "velocity";
    case OfPlatform::angular_velocity:
      return "angular_velocity";
    case OfPlatform::acceleration:
      return "acceleration";
    case OfPlatform::angular_acceleration:
      return "angular_acceleration";
    case OfPlatform::deflection:
      return "deflection";
    case OfPlatform::deflection_turn:
      return "deflection_turn";
  }
  return "";
}

std::string word_of(OfElement what) {
  switch (what) {
    case OfElement::axial:
      return "axial";
    case OfElement::bending:
      return "bending";
    case OfElement::torque:
      return "torque";
    case OfElement::buckling:
      return "buckling";
    case OfElement::share:
      return "share";
  }
  return "";
}

std::string group_of(const std::string& kind, OfMotion what) { return kind + suffix_of(what); }

ColumnId column_of(const Coordinate& coordinate, OfMotion what) { return ColumnId::named(coordinate.name + suffix_of(what)); }
ColumnId column_of(const Derived& derived, OfMotion what) { return ColumnId::named(derived.name + suffix_of(what)); }
ColumnId column_of(const Actuator& actuator, OfMotion what) { return ColumnId::named(actuator.name + suffix_of(what)); }
ColumnId column_of(const Actuator& actuator, OfActuator what) { return ColumnId::named(actuator.name + suffix_of(what)); }
ColumnId column_of(const Reading& reading) { return ColumnId::named(reading.name); }
ColumnId column_of(const Constraint& constraint) { return ColumnId::named(constraint.name); }
ColumnId transmission_of(const Constraint& constraint) { return ColumnId::named(constraint.name + transmission); }
ColumnId column_of(const Joint& joint, OfJoint what) { return ColumnId::named(joint.name + suffix_of(what)); }
ColumnId column_of(OfPlatform vector, std::size_t axis) { return ColumnId::named(fmt::format("{}_{}", word_of(vector), "xyz"[axis])); }
ColumnId column_of(OfMachine what) { return ColumnId::named(name_of(what)); }

ColumnId column_of(const Element& element, OfElement what) { return ColumnId::named(element.name + "_" + word_of(what)); }
ColumnId column_of(OfStiffness what) { return ColumnId::named(name_of(what)); }
ColumnId frequency_column(int mode) { return ColumnId::named(fmt::format("frequency{}", mode)); }

ColumnId joint_column(const Joint& joint, std::size_t limit) { return ColumnId::named(mechanics::motion_name(joint, limit)); }

ColumnId reaction_column(const Joint& joint, int c, bool base_axes) {
  return ColumnId::named(fmt::format("{}{}_{}", joint.name, suffix_of(part_of(c)), (base_axes ? "xyz" : "123")[c % 3]));
}

ColumnId limb_column(int limb, int c) { return ColumnId::named(fmt::format("limb{}{}_{}", limb, suffix_of(part_of(c)), "xyz"[c % 3])); }

std::string owner_of(const ColumnId& column) {
  std::string out = column.name();
  for (const std::string& suffix : {suffix_of(OfMotion::rate), suffix_of(OfMotion::acceleration), suffix_of(OfActuator::dynamic_force),
                                    suffix_of(OfActuator::static_force), suffix_of(OfActuator::pressure), suffix_of(OfActuator::output),
                                    suffix_of(OfActuator::input), std::string(transmission), std::string(deflection), std::string(angle)})
    if (out.ends_with(suffix)) out.erase(out.size() - suffix.size());
  return out;
}

bool of_motor(const Actuator& actuator, const ColumnId& column) {
  const auto motors = {OfActuator::motor_torque, OfActuator::motor_speed, OfActuator::motor_power};
  return std::any_of(motors.begin(), motors.end(), [&](OfActuator what) { return column == column_of(actuator, what); });
}

}  // namespace pmreport::analysis
