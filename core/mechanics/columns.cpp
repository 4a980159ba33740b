#include <core/mechanics/columns.hpp>

#include <fmt/core.h>

namespace pmreport::mechanics {

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

}  // namespace

std::vector<Column> columns_of(std::string_view section, const Topology& t) {
  std::vector<Column> out;
  if (section == "displacement") {
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
  } else if (section == "velocity") {
    add_pose(out, t, "_rate", "s", "coordinate_rate", "rate of ");
    add_vector(out, "velocity", "m/s", "velocity");
    add_vector(out, "angular_velocity", "rad/s", "angular velocity");
    add_actuators(out, t, "_rate", "s", "rate of ");
    out.push_back({"det_G", "", "det_G", "determinant of the overall Jacobian"});
    out.push_back({"condition", "", "condition", "condition number of the overall Jacobian"});
  } else if (section == "acceleration") {
    add_pose(out, t, "_acceleration", "s^2", "coordinate_acceleration", "acceleration of ");
    add_vector(out, "acceleration", "m/s^2", "acceleration");
    add_vector(out, "angular_acceleration", "rad/s^2", "angular acceleration");
    add_actuators(out, t, "_acceleration", "s^2", "acceleration of ");
  } else if (section == "statics") {
    for (const Actuator& a : t.actuators)
      out.push_back({a.name + "_force", a.unit == "m" ? "N" : "N*m", "actuator_force", "force of actuator " + a.name});
    for (const Constraint& c : t.constraints) out.push_back({c.name, c.unit, "constraint", c.title});
  }
  return out;
}

std::string joint_column(const Joint& joint, std::size_t limit) {
  if (joint.kind == JointKind::spherical) return joint.name + "_deflection";
  return joint.name + "_angle" + (joint.limits.size() > 1 ? std::to_string(limit + 1) : "");
}

std::vector<std::string> sections_with_columns() { return {"displacement", "velocity", "acceleration", "statics"}; }

}  // namespace pmreport::mechanics
