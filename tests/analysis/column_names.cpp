// What columns are called, from the words of the data files; and that a text alone asks for none.
#include <core/analysis/columns.hpp>

#include <catch2/catch.hpp>

#include <string>
#include <type_traits>
#include <vector>

using namespace pmreport;
using namespace pmreport::analysis;

namespace {

const Actuator leg{"l1", "length of limb 1", "m", 1, {0, 1}};
const Joint ball{"A1", JointKind::spherical, 0, 1, {{0, 1}}, 1}, hinge{"R5", JointKind::revolute, 0, 1, {{-1, 1}}, -1},
    cross{"U1", JointKind::universal, 0, 1, {{-1, 1}, {-1, 1}}, -1};

}  // namespace

TEST_CASE("what moves has columns of its value, its rate and its acceleration") {
  const Coordinate x{"x", "X position", "m", 0, {}};
  const Derived y{"y", "Y position", "m", true};
  CHECK(column_of(x).name() == "x");
  CHECK(column_of(y, OfMotion::rate).name() == "y_rate");
  CHECK(column_of(leg, OfMotion::acceleration).name() == "l1_acceleration");
}

TEST_CASE("columns of an actuator bear its name and what is measured") {
  CHECK(column_of(leg, OfActuator::static_force).name() == "l1_force");
  CHECK(column_of(leg, OfActuator::dynamic_force).name() == "l1_dynamic_force");
  CHECK(column_of(leg, OfActuator::reflected_inertia).name() == "l1_reflected_inertia");
}

TEST_CASE("columns of joints, limbs and the platform bear the axis of their component") {
  CHECK(column_of(hinge, OfJoint::moment).name() == "R5_moment");
  CHECK(reaction_column(hinge, 2, false).name() == "R5_force_3");
  CHECK(reaction_column(hinge, 3, true).name() == "R5_moment_x");
  CHECK(limb_column(2, 4).name() == "limb2_moment_y");
  CHECK(column_of(OfPlatform::angular_velocity, 2).name() == "angular_velocity_z");
}

TEST_CASE("the angles of a joint are counted where it has several, and a ball has a deflection") {
  CHECK(joint_column(ball, 0).name() == "A1_deflection");
  CHECK(joint_column(hinge, 0).name() == "R5_angle");
  CHECK(joint_column(cross, 1).name() == "U1_angle2");
}

TEST_CASE("the column that a list names is the one that its owner names") {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  t.actuators = {leg};
  t.joints = {hinge};
  const std::vector<Column> forces = dynamics_columns(t), wrenches = reaction_columns(t);
  CHECK(ColumnId(forces.front()) == column_of(leg, OfActuator::dynamic_force));
  CHECK(ColumnId(forces.back()) == column_of(OfMachine::potential_energy));
  CHECK(ColumnId(wrenches.front()) == column_of(hinge, OfJoint::force));
}

TEST_CASE("a column tells what it belongs to") {
  for (const ColumnId& column : {column_of(leg), column_of(leg, OfMotion::rate), column_of(leg, OfMotion::acceleration),
                                 column_of(leg, OfActuator::static_force), column_of(leg, OfActuator::dynamic_force)})
    CHECK(owner_of(column) == "l1");
  CHECK(owner_of(joint_column(ball, 0)) == "A1");
  CHECK(owner_of(joint_column(hinge, 0)) == "R5");
}

TEST_CASE("columns of a motor are those of its own actuator alone") {
  const Actuator other{"l11", "length of limb 11", "m", 1, {0, 1}};
  CHECK(of_motor(leg, column_of(leg, OfActuator::motor_speed)));
  CHECK_FALSE(of_motor(leg, column_of(other, OfActuator::motor_speed)));
  CHECK_FALSE(of_motor(leg, column_of(leg, OfActuator::drive_power)));
}

TEST_CASE("a text becomes a column only where that is said") {
  STATIC_REQUIRE_FALSE(std::is_constructible_v<ColumnId, std::string>);
  STATIC_REQUIRE_FALSE(std::is_constructible_v<ColumnId, const char*>);
  CHECK(ColumnId::named("l1_rate") == column_of(leg, OfMotion::rate));
}
