#include <core/analysis/columns.hpp>

#include <catch2/catch.hpp>
#include <set>

using namespace pmreport;
using namespace pmreport::analysis;

namespace {

Topology sample() {
  Topology t;
  t.coordinates = {{"x", "X position", "m", 0, {}}, {"alpha", "rotation about Z", "rad", 0, {}}};
  t.derived = {{"y", "Y position", "m", true}, {"tilt", "tilt of the platform", "rad", false}};
  t.platform = t.add(Body{"platform", 0, false, {}});
  t.joints = {{"A1", JointKind::spherical, 0, 1, {{0, 1}}, 1},
              {"P1", JointKind::prismatic, 0, 1, {{0, 1}}, -1},
              {"R5", JointKind::revolute, 0, 1, {{-1, 1}}, -1},
              {"U1", JointKind::universal, 0, 1, {{-1, 1}, {-1, 1}}, -1}};
  t.actuators = {{"l1", "length of limb 1", "m", 1, {0, 1}}, {"q1", "angle of motor 1", "rad", 2, {0, 1}}};
  t.constraints = {{"constraint1", "force along n6", "N"}, {"constraint2", "couple about n6", "N*m"}};
  return t;
}

std::vector<std::string> headers(ColumnList* list) {
  std::vector<std::string> out;
  for (const Column& c : list(sample())) out.push_back(c.name + " [" + c.unit + "]");
  return out;
}

using Strings = std::vector<std::string>;

}  // namespace

TEST_CASE("displacement lists the pose, dependent coordinates after independent ones, then actuators and motions of joints") {
  CHECK(headers(displacement_columns) == Strings{"x [m]", "alpha [rad]", "y [m]", "tilt [rad]", "l1 [m]", "q1 [rad]", "A1_deflection [rad]",
                                                 "P1_travel [m]", "R5_angle [rad]", "U1_angle1 [rad]", "U1_angle2 [rad]"});
}

TEST_CASE("velocity lists rates, the platform's twist and how well the Jacobian is conditioned") {
  CHECK(headers(velocity_columns) == Strings{"x_rate [m/s]", "alpha_rate [rad/s]", "y_rate [m/s]", "tilt_rate [rad/s]", "velocity_x [m/s]",
                                             "velocity_y [m/s]", "velocity_z [m/s]", "angular_velocity_x [rad/s]",
                                             "angular_velocity_y [rad/s]", "angular_velocity_z [rad/s]", "l1_rate [m/s]", "q1_rate [rad/s]",
                                             "det_G []", "condition []"});
}

TEST_CASE("acceleration lists accelerations") {
  CHECK(headers(acceleration_columns) == Strings{"x_acceleration [m/s^2]", "alpha_acceleration [rad/s^2]", "y_acceleration [m/s^2]",
                                                 "tilt_acceleration [rad/s^2]", "acceleration_x [m/s^2]", "acceleration_y [m/s^2]",
                                                 "acceleration_z [m/s^2]", "angular_acceleration_x [rad/s^2]",
                                                 "angular_acceleration_y [rad/s^2]", "angular_acceleration_z [rad/s^2]",
                                                 "l1_acceleration [m/s^2]", "q1_acceleration [rad/s^2]"});
}

TEST_CASE("statics lists forces of linear and torques of rotary actuators, then the constraint wrenches") {
  CHECK(headers(statics_columns) == Strings{"l1_force [N]", "q1_force [N*m]", "constraint1 [N]", "constraint2 [N*m]"});
}

TEST_CASE("a group names the actuators together, and no dependent coordinate among them") {
  Strings lengths, forces, coordinates;
  for (const Column& c : displacement_columns(sample())) {
    if (c.group == "actuator") lengths.push_back(c.name);
    if (c.group == "coordinate") coordinates.push_back(c.name);
  }
  for (const Column& c : statics_columns(sample()))
    if (c.group == "actuator_force") forces.push_back(c.name);
  CHECK(lengths == Strings{"l1", "q1"});
  CHECK(coordinates == Strings{"x", "alpha", "y"});
  CHECK(forces == Strings{"l1_force", "q1_force"});
}

TEST_CASE("column names are unique over all lists, and every column has a title") {
  std::set<std::string> seen;
  for (ColumnList* list :
       {displacement_columns, velocity_columns, acceleration_columns, statics_columns, dynamics_columns, drive_columns, reaction_columns})
    for (const Column& c : list(sample())) {
      CAPTURE(c.name);
      CHECK(seen.insert(c.name).second);
      CHECK_FALSE(c.title.empty());
      CHECK_FALSE(c.group.empty());
    }
}
