#include <core/analysis/columns.hpp>
#include <core/mechanics/model/effort.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace pmreport::analysis {

namespace {

std::string per(const std::string& unit, const char* time) { return unit + "/" + time; }

// The coordinates of the platform's pose: independent ones, then dependent ones.
void add_pose(std::vector<Column>& out, const Topology& t, const char* suffix, const char* time, const char* group, const char* words) {
  const auto add = [&](const std::string& name, const std::string& title, const std::string& unit, const std::string& in) {
    out.push_back({name + suffix, *time != '\0' ? per(unit, time) : unit, in, words + title});
  };
  for (const Coordinate& c : t.coordinates) add(c.name, c.title, c.unit, group);
  for (const Derived& d : t.derived) add(d.name, d.title, d.unit, d.dependent ? group : std::string("derived") + suffix);
}

void add_actuators(std::vector<Column>& out, const Topology& t, const char* suffix, const char* time, const char* words) {
  for (const Actuator& a : t.actuators)
    out.push_back({a.name + suffix, *time != '\0' ? per(a.unit, time) : a.unit, std::string("actuator") + suffix, words + a.title});
}

void add_vector(std::vector<Column>& out, const std::string& name, const char* unit, const char* words) {
  for (const char* axis : {"x", "y", "z"})
    out.push_back({name + "_" + axis, unit, name, fmt::format("{} of the platform, {}", words, axis)});
}

const char* force_unit(const Actuator& a) { return mechanics::unit_of_effort(a.sense()); }

// One column an actuator: NAME_suffix.
void add_forces(std::vector<Column>& out, const Topology& t, const std::string& suffix, const char* words) {
  for (const Actuator& a : t.actuators)
    out.push_back({a.name + "_" + suffix, force_unit(a), suffix, fmt::format("{} of {}", words, a.name)});
}
void add_of_actuators(std::vector<Column>& out, const Topology& t, const std::string& suffix, const char* unit, const char* words) {
  for (const Actuator& a : t.actuators) out.push_back({a.name + "_" + suffix, unit, suffix, fmt::format("{} of {}", words, a.name)});
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

std::string reaction_column(const Joint& joint, int c, bool base_axes) {
  return fmt::format("{}_{}_{}", joint.name, c < 3 ? "force" : "moment", (base_axes ? "xyz" : "123")[c % 3]);
}

std::string limb_column(int limb, int c) { return fmt::format("limb{}_{}_{}", limb, c < 3 ? "force" : "moment", "xyz"[c % 3]); }

int limbs_of(const Topology& t) {
  int out = 0;
  for (const Body& b : t.bodies) out = std::max(out, b.limb);
  return out;
}

std::vector<Column> displacement_columns(const Topology& t) {
  std::vector<Column> out;
  add_pose(out, t, "", "", "coordinate", "");
  add_actuators(out, t, "", "", "");
  for (const Reading& r : t.readings) out.push_back({r.name, r.unit, "reading", r.title});
  for (const Joint& j : t.joints) {
    if (j.kind == JointKind::prismatic) continue;
    const bool ball = j.kind == JointKind::spherical;
    for (std::size_t k = 0; k < j.limits.size(); ++k)
      out.push_back(
          {joint_column(j, k), "rad", "joint_angle", fmt::format("{} of joint {} from home", ball ? "deflection" : "rotation", j.name)});
  }
  return out;
}

std::vector<Column> velocity_columns(const Topology& t) {
  std::vector<Column> out;
  add_pose(out, t, "_rate", "s", "coordinate_rate", "rate of ");
  add_vector(out, "velocity", "m/s", "velocity");
  add_vector(out, "angular_velocity", "rad/s", "angular velocity");
  add_actuators(out, t, "_rate", "s", "rate of ");
  out.push_back({"det_G", "", "det_G", "determinant of the overall Jacobian"});
  out.push_back({"condition", "", "condition", "condition number of the overall Jacobian"});
  return out;
}

std::vector<Column> acceleration_columns(const Topology& t) {
  std::vector<Column> out;
  add_pose(out, t, "_acceleration", "s^2", "coordinate_acceleration", "acceleration of ");
  add_vector(out, "acceleration", "m/s^2", "acceleration");
  add_vector(out, "angular_acceleration", "rad/s^2", "angular acceleration");
  add_actuators(out, t, "_acceleration", "s^2", "acceleration of ");
  return out;
}

std::vector<Column> statics_columns(const Topology& t) {
  std::vector<Column> out;
  for (const Actuator& a : t.actuators) out.push_back({a.name + "_force", force_unit(a), "actuator_force", "force of actuator " + a.name});
  for (const Constraint& c : t.constraints) out.push_back({c.name, c.unit, "constraint", c.title});
  return out;
}

std::vector<Column> dynamics_columns(const Topology& t) {
  std::vector<Column> out;
  add_forces(out, t, "dynamic_force", "force");
  add_forces(out, t, "load_force", "share of the load in the force");
  add_forces(out, t, "gravity_force", "share of the weights in the force");
  add_forces(out, t, "inertia_force", "share of inertia in the force");
  add_of_actuators(out, t, "power", "W", "mechanical power");
  out.push_back({"total_power", "W", "total_power", "mechanical power of all actuators"});
  out.push_back({"load_power", "W", "load_power", "power of the load on the platform"});
  out.push_back({"kinetic_energy", "J", "kinetic_energy", "kinetic energy of all bodies"});
  out.push_back({"potential_energy", "J", "potential_energy", "potential energy of all bodies, zero at the base's origin"});
  return out;
}

std::vector<Column> drive_columns(const Topology& t) {
  std::vector<Column> out;
  add_forces(out, t, "drive_force", "force that the drive must give");
  add_of_actuators(out, t, "drive_power", "W", "power that the drive must give");
  add_of_actuators(out, t, "motor_torque", "N*m", "motor torque");
  add_of_actuators(out, t, "motor_speed", "rad/s", "motor speed");
  add_of_actuators(out, t, "motor_power", "W", "motor power");
  for (const Actuator& a : t.actuators)
    out.push_back({a.name + "_reflected_inertia", mechanics::unit_of_inertia(a.sense()), "reflected_inertia",
                   fmt::format("inertia that {} feels, the other actuators held", a.name)});
  return out;
}

std::vector<Column> reaction_columns(const Topology& t) {
  std::vector<Column> out;
  for (const Joint& j : t.joints) {
    out.push_back({j.name + "_force", "N", "joint_force", "size of the force in joint " + j.name});
    if (j.kind != JointKind::spherical) out.push_back({j.name + "_moment", "N*m", "joint_moment", "size of the moment in joint " + j.name});
  }
  for (const bool base : {false, true})
    for (const Joint& j : t.joints)
      for (int c = 0; c < 6; ++c) {
        if (base ? c > 2 && j.kind == JointKind::spherical : !transmits(j.kind, c)) continue;
        out.push_back({reaction_column(j, c, base), c < 3 ? "N" : "N*m", base ? "base_reaction" : "reaction",
                       fmt::format("{} in joint {}, {} {}", c < 3 ? "force" : "moment", j.name, base ? "base axis" : "joint axis",
                                   base ? "xyz"[c % 3] : "123"[c % 3])});
      }
  for (int limb = 1; limb <= limbs_of(t); ++limb)
    for (int c = 0; c < 6; ++c)
      out.push_back(
          {limb_column(limb, c), c < 3 ? "N" : "N*m", "limb_wrench",
           fmt::format("{} of limb {} on the platform, {}", c < 3 ? "force" : "moment about the reference point", limb, "xyz"[c % 3])});
  return out;
}

std::string joint_column(const Joint& joint, std::size_t limit) {
  if (joint.kind == JointKind::spherical) return joint.name + "_deflection";
  return joint.name + "_angle" + (joint.limits.size() > 1 ? std::to_string(limit + 1) : "");
}

}  // namespace pmreport::analysis
