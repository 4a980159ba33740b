// The usual mistakes of an author, each with the sentence that leads to it.
#include <tests/mechanics/conformance/tilt_table.hpp>

using namespace pmreport;
using namespace pmreport::test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

constexpr double edge = 0.2;  // of the table

}  // namespace

TEST_CASE("the table without a mistake has every property") { CHECK(failures(Mistake::none).empty()); }

TEST_CASE("a joint that does not close is named with both bodies and the gap") {
  const std::string where = failure(Mistake::edge_not_turned, "joints close");
  CHECK_THAT(where, StartsWith("joint B1 (spherical, piston 1 and table) at alpha = ") &&
                        Contains("the point where piston 1 and table meet at home is ") && Contains(" mm away from itself; look at "));
  // The gap told is the largest, and that of the property: the chord of the edge's way, whatever beta is, up to alpha = 0.3.
  const auto at = where.find("at home is ");
  CHECK(std::stod(where.substr(at + 11)) < 1e3 * 2 * edge * std::sin(0.15));
  CHECK(std::stod(where.substr(at + 11)) > 0.9e3 * 2 * edge * std::sin(0.15));
}

TEST_CASE("a joint that place does not give is named") {
  CHECK_THAT(failure(Mistake::joint_not_given, "joints close"), StartsWith("joint B2 (spherical, piston 2 and table)") &&
                                                                    Contains("its centre is (0, 0, 0), at home too") &&
                                                                    Contains("does place give joint B2?"));
}

TEST_CASE("a body that place does not put anywhere is named") {
  CHECK_THAT(failure(Mistake::body_not_placed, "axes and rotations are unit"),
             StartsWith("home: body piston 2: its axis is zero; does place put it anywhere?"));
}

TEST_CASE("a body whose axis is not of unit length is named with its length") {
  const std::string where = failure(Mistake::axis_not_unit, "axes and rotations are unit");
  CHECK_THAT(where, Contains(": body cylinder 1: its axis has length 0.") && Contains("is it divided by its length"));
  // The leg is shortest where it is farthest from unit length: near 0.3 m less 0.2 m sin(0.3).
  CHECK(std::stod(where.substr(where.find("has length ") + 11)) == Approx(height - edge * std::sin(0.3)).epsilon(0.05));
}

TEST_CASE("axes that place does not give are named") {
  CHECK_THAT(failure(Mistake::axis_not_given, "axes and rotations are unit"),
             StartsWith("home: axis 1 of joint U (universal, base and table) is zero; does place give this joint with its axes?"));
}

TEST_CASE("an axis that does not follow its body is found by the motion, and the joint named") {
  CHECK_THAT(failure(Mistake::axis_left_behind, "relative velocities are allowed"),
             StartsWith("joint U (universal, base and table) at alpha = ") &&
                 Contains("base and table move against each other as no universal joint allows") && Contains("look at its kind, its axes"));
}

TEST_CASE("a wrong axis is named with the angle by which it is wrong") {
  CHECK_THAT(failure(Mistake::turns_swapped, "joint axes agree"),
             StartsWith("joint U (universal, base and table) at alpha = ") && Contains(" deg from perpendicular; axis 1 must be fixed in "
                                                                                       "base, axis 2 in table"));
}

TEST_CASE("a joint of the wrong kind is named with what it forbids") {
  CHECK_THAT(failure(Mistake::other_kind, "joint axes agree"),
             StartsWith("joint U (revolute, base and table)") &&
                 Contains("its axis as base carries it and as table carries it differ by ") && Contains(" deg; it must be fixed in both"));
  CHECK_THAT(failure(Mistake::other_kind, "mobility is as declared"),
             Contains("found 1 degrees of freedom and 2 idle, declared 2 and 2; the joints hold more than the coordinates move"));
}

TEST_CASE("a forgotten limb is told by what nothing holds") {
  CHECK(refusal(Mistake::leg_not_connected) ==
        "no chain of joints leads from the base to: cylinder 2, piston 2; is a joint, or a limb, forgotten?");
  CHECK(refusal(Mistake::leg_left_out) == "declares 2 degrees of freedom, but 1 actuators; is a limb forgotten?");
  CHECK_THAT(failure(Mistake::leg_hangs, "mobility is as declared"),
             Contains("with every actuator held table, cylinder 2 and piston 2 can still move, the platform can turn about (0.000, 1.000, "
                      "0.000): a coordinate with its actuator is missing, or a joint or a limb, or a joint allows too much"));
}

TEST_CASE("too few coordinates are told by the motion that is left") {
  CHECK(refusal(Mistake::one_coordinate_less) ==
        "declares 2 degrees of freedom, but 1 independent coordinates; Mechanism<2> and topology() must say the same");
  CHECK_THAT(failure(Mistake::one_coordinate, "mobility is as declared"),
             Contains("found 2 degrees of freedom and 1 idle, declared 1 and 1; with every actuator held table") &&
                 Contains("can still move, the platform can turn about (0.000, 1.000, 0.000): a coordinate with its actuator is missing"));
}

TEST_CASE("idle spins that are not declared are counted, and their bodies named") {
  CHECK_THAT(failure(Mistake::spins_not_declared, "mobility is as declared"),
             Contains("found 2 degrees of freedom and 2 idle, declared 2 and 0; about themselves spin cylinder 1, piston 1, cylinder 2 and "
                      "piston 2: declare 2 idle freedoms"));
}

TEST_CASE("an actuator that does not measure its joint is named with both rates") {
  CHECK_THAT(failure(Mistake::drive_backwards, "actuators measure their joints"),
             Contains(": actuator l1 changes by ") && Contains(" m/s, joint P1 (prismatic, cylinder 1 and piston 1) by ") &&
                 Contains("look at its sign"));
}

TEST_CASE("the wrong row of a Jacobian is named") {
  CHECK_THAT(failure(Mistake::wrong_moment, "jacobian gives the actuator rates"), Contains(": row 1 of the Jacobian (l1)"));
}
