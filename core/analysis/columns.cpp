#include <core/analysis/columns.hpp>
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/machine/limb_line.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/joint_motion.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <tuple>

namespace pmreport::analysis {

namespace {

std::string per(const std::string& unit, const char* time) { return unit + "/" + time; }

// What moves of the machine, x: its value, rate or acceleration. `time`: by which its unit is divided; empty: by none.
template <class Moved>
void add_moved(std::vector<Column>& out, const Moved& x, OfMotion what, const char* time, const std::string& kind, const char* words) {
  out.push_back({column_of(x, what).name(), *time != '\0' ? per(x.unit, time) : x.unit, group_of(kind, what), words + x.title});
}

// The coordinates of the platform's pose: independent ones, then dependent ones.
void add_pose(std::vector<Column>& out, const Topology& t, OfMotion what, const char* time, const char* words) {
  for (const Coordinate& c : t.coordinates) add_moved(out, c, what, time, "coordinate", words);
  for (const Derived& d : t.derived) add_moved(out, d, what, time, d.dependent ? "coordinate" : "derived", words);
}

void add_actuators(std::vector<Column>& out, const Topology& t, OfMotion what, const char* time, const char* words) {
  for (const Actuator& a : t.actuators) add_moved(out, a, what, time, "actuator", words);
}

void add_vector(std::vector<Column>& out, OfPlatform vector, const char* unit, const char* words) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    out.push_back({column_of(vector, axis).name(), unit, word_of(vector), fmt::format("{} of the platform, {}", words, "xyz"[axis])});
}

const char* force_unit(const Actuator& a) { return mechanics::unit_of_effort(a.sense()); }

// One column an actuator.
void add_of_actuators(std::vector<Column>& out, const Topology& t, OfActuator what, const char* unit, const char* words) {
  for (const Actuator& a : t.actuators)
    out.push_back({column_of(a, what).name(), unit, word_of(what), fmt::format("{} of {}", words, a.name)});
}
// A force, or the torque of a rotary one, with words before and after.
void add_forces(std::vector<Column>& out, const Topology& t, OfActuator what, const char* before = "", const char* after = "") {
  for (const Actuator& a : t.actuators)
    out.push_back({column_of(a, what).name(), force_unit(a), word_of(what),
                   fmt::format("{}{}{} of {}", before, mechanics::word_of_effort(a.sense()), after, a.name)});
}

// A group of its own.
void add_single(std::vector<Column>& out, OfMachine what, const char* unit, const char* words) {
  const std::string name = column_of(what).name();
  out.push_back({name, unit, name, words});
}

}  // namespace

bool transmits(JointKind kind, int c) {
  switch (kind) {
    case JointKind::revolute:
      return c != 3;
    case JointKind::prismatic:
      return c != 0;
    case JointKind::universal:
      return c < 3 || c == 5;
    case JointKind::spherical:
      return c < 3;
    case JointKind::cylindrical:
      return c != 0 && c != 3;
  }
  return false;
}

std::vector<Column> displacement_columns(const Topology& t) {
  std::vector<Column> out;
  add_pose(out, t, OfMotion::value, "", "");
  add_actuators(out, t, OfMotion::value, "", "");
  for (const Reading& r : t.readings) out.push_back({column_of(r).name(), r.unit, "reading", r.title});
  for (const Joint& j : t.joints) {
    const bool slide = j.kind == JointKind::prismatic;
    const char* motion = slide ? "travel" : j.kind == JointKind::spherical ? "deflection" : "rotation";
    for (std::size_t k = 0; k < j.limits.size(); ++k)
      if (mechanics::is_told(j, k))
        out.push_back({joint_column(j, k).name(), mechanics::motion_unit(j), slide ? "joint_travel" : "joint_angle",
                       fmt::format("{} of joint {} from {}", motion, j.name, mechanics::origin_of(t, j))});
  }
  return out;
}

std::vector<Column> velocity_columns(const Topology& t) {
  std::vector<Column> out;
  add_pose(out, t, OfMotion::rate, "s", "rate of ");
  add_vector(out, OfPlatform::velocity, "m/s", "velocity");
  add_vector(out, OfPlatform::angular_velocity, "rad/s", "angular velocity");
  add_actuators(out, t, OfMotion::rate, "s", "rate of ");
  add_single(out, OfMachine::determinant, "", "determinant of the overall Jacobian");
  add_single(out, OfMachine::condition, "", "condition number of the overall Jacobian");
  return out;
}

std::vector<Column> acceleration_columns(const Topology& t) {
  std::vector<Column> out;
  add_pose(out, t, OfMotion::acceleration, "s^2", "acceleration of ");
  add_vector(out, OfPlatform::acceleration, "m/s^2", "acceleration");
  add_vector(out, OfPlatform::angular_acceleration, "rad/s^2", "angular acceleration");
  add_actuators(out, t, OfMotion::acceleration, "s^2", "acceleration of ");
  return out;
}

std::vector<Column> statics_columns(const Topology& t) {
  std::vector<Column> out;
  for (const Actuator& a : t.actuators)
    out.push_back({column_of(a, OfActuator::static_force).name(), force_unit(a), "actuator_force",
                   fmt::format("{} of actuator {}", mechanics::word_of_effort(a.sense()), a.name)});
  for (const Constraint& c : t.constraints) out.push_back({column_of(c).name(), c.unit, "constraint", c.title});
  return out;
}

std::vector<Column> dynamics_columns(const Topology& t) {
  std::vector<Column> out;
  add_forces(out, t, OfActuator::dynamic_force);
  add_forces(out, t, OfActuator::load_force, "share of the load in the ");
  add_forces(out, t, OfActuator::gravity_force, "share of the weights in the ");
  add_forces(out, t, OfActuator::inertia_force, "share of inertia in the ");
  add_of_actuators(out, t, OfActuator::power, "W", "mechanical power");
  add_single(out, OfMachine::total_power, "W", "mechanical power of all actuators");
  add_single(out, OfMachine::load_power, "W", "power of the load on the platform");
  add_single(out, OfMachine::kinetic_energy, "J", "kinetic energy of all bodies");
  add_single(out, OfMachine::potential_energy, "J", "potential energy of all bodies, zero at the base's origin");
  return out;
}

std::vector<Column> drive_columns(const Topology& t) {
  std::vector<Column> out;
  add_forces(out, t, OfActuator::drive_force, "", " that the drive must give");
  add_of_actuators(out, t, OfActuator::drive_power, "W", "power that the drive must give");
  add_of_actuators(out, t, OfActuator::motor_torque, "N*m", "motor torque");
  add_of_actuators(out, t, OfActuator::motor_speed, "rad/s", "motor speed");
  add_of_actuators(out, t, OfActuator::motor_power, "W", "motor power");
  for (const Actuator& a : t.actuators)
    out.push_back({column_of(a, OfActuator::reflected_inertia).name(), mechanics::unit_of_inertia(a.sense()),
                   word_of(OfActuator::reflected_inertia), fmt::format("inertia that {} feels, the other actuators held", a.name)});
  return out;
}

std::vector<Column> transmission_columns(const Topology& t) {
  std::vector<Column> out;
  for (const auto& [what, unit, group, words] : {std::tuple{OfActuator::pressure, "rad", "pressure_angle", "pressure angle"},
                                                 {OfActuator::output, "", "output_transmission", "output transmission index"},
                                                 {OfActuator::input, "", "input_transmission", "input transmission index"}})
    for (const Actuator& a : t.actuators) out.push_back({column_of(a, what).name(), unit, group, fmt::format("{} of {}", words, a.name)});
  for (const Constraint& c : t.constraints)
    out.push_back({transmission_of(c).name(), "", "constraint_transmission", "constraint transmission index of " + c.name});
  add_single(out, OfMachine::local_transmission, "", "local transmission index, the least of all outputs and inputs");
  add_single(out, OfMachine::least_cosine, "", "least cosine of the pressure angles of all drives");
  add_single(out, OfMachine::local_conditioning, "", "local conditioning index, 1 over the condition number");
  add_single(out, OfMachine::manipulability, "", "manipulability, 1 over the magnitude of the determinant");
  return out;
}

std::vector<Column> reaction_columns(const Topology& t) {
  std::vector<Column> out;
  for (const Joint& j : t.joints) {
    out.push_back({column_of(j, OfJoint::force).name(), "N", "joint_force", "size of the force in joint " + j.name});
    if (j.kind != JointKind::spherical)
      out.push_back({column_of(j, OfJoint::moment).name(), "N*m", "joint_moment", "size of the moment in joint " + j.name});
  }
  for (const bool base : {false, true})
    for (const Joint& j : t.joints)
      for (int c = 0; c < 6; ++c) {
        if (base ? c > 2 && j.kind == JointKind::spherical : !transmits(j.kind, c)) continue;
        out.push_back({reaction_column(j, c, base).name(), c < 3 ? "N" : "N*m", base ? "base_reaction" : "reaction",
                       fmt::format("{} in joint {}, {} {}", c < 3 ? "force" : "moment", j.name, base ? "base axis" : "joint axis",
                                   base ? "xyz"[c % 3] : "123"[c % 3])});
      }
  for (int limb = 1; limb <= mechanics::limbs_of(t); ++limb)
    for (int c = 0; c < 6; ++c)
      out.push_back(
          {limb_column(limb, c).name(), c < 3 ? "N" : "N*m", "limb_wrench",
           fmt::format("{} of limb {} on the platform, {}", c < 3 ? "force" : "moment about the reference point", limb, "xyz"[c % 3])});
  return out;
}

}  // namespace pmreport::analysis
