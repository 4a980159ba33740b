// Telescopic legs: where they are put, which way they turn, and the numbers that they have.
#include <catch2/catch.hpp>
#include <pmreport/leg.hpp>
#include <pmreport/mechanism.hpp>
#include <pmreport/parts.hpp>

#include <string>

using namespace pmreport;
using Catch::Contains;
using Eigen::Vector3d;

namespace {

constexpr int platform = 1;
constexpr auto two = legs<2>(platform + 1);

// Two legs between base and platform, with joints of these kinds at their ends.
Topology topology(JointKind low, JointKind high, bool slender = false) {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  const Telescope made{"cylinder ", "piston ", "l", "length of leg ", {1}, {2}, {0.5, 1.5}, slender};
  for (const Leg& leg : two) {
    const std::string n = std::to_string(leg.limb);
    add_leg(t, leg, n, made, {"A" + n, low, 0, leg.cylinder, {}}, {"B" + n, high, leg.piston, platform, {}});
  }
  return t;
}

// A place for such legs, of one pose.
struct Room {
  explicit Room(const Topology& t) : layout(t), numbers(layout.size()), at(numbers.data(), 1, layout) {}
  Layout layout;
  std::vector<double> numbers;
  Placement<double> at;
};

// 13 long, along (3, 4, 12) from (1, 2, 3).
const Line<double> line(Vector3d(1, 2, 3), Vector3d(4, 6, 15));
const Vector3d along = Vector3d(3, 4, 12) / 13;

void check_bodies(const Placement<double>& at, const Leg& leg, const Vector3d& x) {
  CHECK(at.origin(leg.cylinder) == Vector3d(1, 2, 3));
  CHECK(at.origin(leg.piston) == Vector3d(4, 6, 15));
  for (const int body : {leg.cylinder, leg.piston}) {
    const Matrix3<double> r = at.rotation(body);
    CHECK((r.col(2) - along).norm() < 1e-15);
    CHECK((r.col(0) - x).norm() < 1e-15);
    CHECK((r.transpose() * r - Matrix3<double>::Identity()).norm() < 1e-15);
    CHECK(r.determinant() == Approx(1));
  }
  CHECK(at.actuator(leg.drive) == Approx(13).epsilon(1e-15));
  CHECK((at.axis(leg.slide) - along).norm() < 1e-15);
  CHECK(at.centre(leg.slide) == Vector3d(4, 6, 15));
  CHECK(at.centre(leg.low) == Vector3d(1, 2, 3));
  CHECK(at.centre(leg.high) == Vector3d(4, 6, 15));
}

}  // namespace

TEST_CASE("legs have bodies, joints and drives one after the other") {
  CHECK(two[0].limb == 1);
  CHECK(two[1].limb == 2);
  constexpr auto later = legs<3>(4, 2, 2);
  const Leg& last = later[2];
  CHECK(std::vector{last.limb, last.drive, last.cylinder, last.piston, last.low, last.slide, last.high} ==
        std::vector{3, 4, 8, 9, 8, 9, 10});
}

TEST_CASE("a leg is declared with its names, its bodies and its drive") {
  const Topology t = topology(JointKind::universal, JointKind::spherical);
  REQUIRE(t.bodies.size() == 6);
  CHECK(t.bodies[5].name == "piston 2");
  CHECK(t.bodies[5].limb == 2);
  CHECK(t.bodies[5].inertia.mass == 2);
  CHECK_FALSE(t.bodies[5].slender);
  REQUIRE(t.joints.size() == 6);
  CHECK(t.joints[4].name == "P2");
  CHECK(t.joints[4].kind == JointKind::prismatic);
  CHECK(t.joints[4].a == 4);
  CHECK(t.joints[4].b == 5);
  REQUIRE(t.actuators.size() == 2);
  CHECK(t.actuators[1].name == "l2");
  CHECK(t.actuators[1].title == "length of leg 2");
  CHECK(t.actuators[1].joint == 4);
  CHECK(t.actuators[1].stroke.max == 1.5);
}

TEST_CASE("a leg that is declared in another order than it is numbered is refused by its name") {
  Topology t;
  t.platform = t.add(Body{"platform", 0, false, {}});
  t.add(Body{"one body more", 0, false, {}});
  CHECK_THROWS_WITH(add_leg(t, two[0], "1", {}, {}, {}), Contains("leg 1"));
}

TEST_CASE("a leg on a Cardan joint does not spin: the second axis lies across the first and the leg") {
  Room room(topology(JointKind::universal, JointKind::spherical));
  place_ups<double>(room.at, two[1], line, Vector3d::UnitX());
  const Vector3d e2 = Vector3d(0, -12, 4) / std::sqrt(160);  // x cross (3, 4, 12)
  check_bodies(room.at, two[1], e2);
  CHECK(room.at.axis(two[1].low, 0) == Vector3d(Vector3d::UnitX()));
  CHECK((room.at.axis(two[1].low, 1) - e2).norm() < 1e-15);
  CHECK(room.at.reach() == Approx(std::sqrt(160) / 13 - 1e-6));  // the sine between leg and first axis
  CHECK(room.at.why() == nullptr);
}

TEST_CASE("the same leg upside down carries its Cardan joint above") {
  Room room(topology(JointKind::spherical, JointKind::universal));
  const Matrix3<double> r = place_spu<double>(room.at, two[0], line, Vector3d::UnitX());
  const Vector3d e2 = Vector3d(0, -12, 4) / std::sqrt(160);
  check_bodies(room.at, two[0], e2);
  CHECK(room.at.axis(two[0].high, 0) == Vector3d(Vector3d::UnitX()));
  CHECK((room.at.axis(two[0].high, 1) - e2).norm() < 1e-15);
  CHECK(r == room.at.rotation(two[0].cylinder));
}

TEST_CASE("a leg along the first axis of its Cardan joint is out of reach, and says why") {
  Room room(topology(JointKind::universal, JointKind::spherical));
  place_ups<double>(room.at, two[0], line, along);
  CHECK(room.at.reach() < 0);
  REQUIRE(room.at.why() != nullptr);
  CHECK_THAT(room.at.why(), Contains("its spin is undetermined"));
}

TEST_CASE("a leg between two balls is slender and has no axes but its own") {
  Room room(topology(JointKind::spherical, JointKind::spherical, true));
  place_sps(room.at, two[1], line);
  CHECK(room.at.origin(two[1].cylinder) == Vector3d(1, 2, 3));
  CHECK(room.at.origin(two[1].piston) == Vector3d(4, 6, 15));
  for (const int body : {two[1].cylinder, two[1].piston}) CHECK((room.at.spine(body) - along).norm() < 1e-15);
  CHECK(room.at.centre(two[1].low) == Vector3d(1, 2, 3));
  CHECK(room.at.centre(two[1].high) == Vector3d(4, 6, 15));
  CHECK(room.at.actuator(1) == Approx(13).epsilon(1e-15));
}

TEST_CASE("a leg with a hinge has its bodies turned to the hinge") {
  Room room(topology(JointKind::revolute, JointKind::revolute));
  const Vector3d across = Vector3d(4, -3, 0) / 5;
  place_leg<double>(room.at, two[0], line, across);
  room.at.joint(two[0].low, line.from, across);
  room.at.joint(two[0].high, line.to, across);
  check_bodies(room.at, two[0], across);
}

TEST_CASE("both parts of a drawn leg have the length told, the cylinder from its foot, the piston from its head") {
  Topology t = topology(JointKind::universal, JointKind::spherical);
  draw_leg(t, two[1], 0.4, 0.02, 0.01);
  REQUIRE(t.shapes.size() == 2);
  CHECK(t.shapes[0].body == two[1].cylinder);
  CHECK(t.shapes[0].b == Vector3d(0, 0, 0.4));
  CHECK(t.shapes[0].radius == 0.02);
  CHECK(t.shapes[1].body == two[1].piston);
  CHECK(t.shapes[1].a == Vector3d(0, 0, -0.4));
  CHECK(t.shapes[1].b.isZero());
}

TEST_CASE("limits and inertias are read from the parameters that a part is named by") {
  static constexpr Parameter declared[] = {Parameter::length("stroke_min", 0.4, ""),    Parameter::length("stroke_max", 0.9, ""),
                                           Parameter::mass("rod_mass", 12, ""),         Parameter::length("rod_radius", 2, ""),
                                           Parameter::inertia("rod_inertia", 0.07, ""), Parameter::inertia("rod_axial_inertia", 0.01, "")};
  std::vector<pm_value> values;
  for (const Parameter& p : declared) values.push_back({&p.default_number, 1});
  const Parameters p(declared, values);

  const Range stroke = range_of(p, "stroke_min", "stroke_max");
  CHECK(stroke.min == 0.4);
  CHECK(stroke.max == 0.9);
  CHECK_THROWS_WITH(range_of(p, "stroke_max", "stroke_min"), "stroke_max must be less than stroke_min");
  CHECK_THROWS_AS(range_of(p, "stroke_max", "stroke_max"), std::invalid_argument);
  CHECK(either_way(0.3).min == -0.3);
  CHECK(either_way(0.3).max == 0.3);
  CHECK(up_to(0.3).min == 0);
  CHECK(up_to(0.3).max == 0.3);

  const Inertia turned = axisymmetric(p, "rod", 0.2), solid = solid_cylinder(p, "rod", -3, 1);
  CHECK(turned.mass == 12);
  CHECK(turned.centre == Vector3d(0, 0, 0.2));
  CHECK(turned.about_centre.diagonal() == Vector3d(0.07, 0.07, 0.01));
  // m (3 r^2 + h^2) / 12 across, m r^2 / 2 along, for m = 12, r = 2, h = 4.
  CHECK(solid.centre == Vector3d(0, 0, -1));
  CHECK(solid.about_centre.diagonal() == Vector3d(28, 28, 24));
}
