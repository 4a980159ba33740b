// Declarations that no machine can have: refused when the mechanism is made, by name.
#include <tests/mechanics/conformance/tilt_table.hpp>

using namespace pmreport::test;

TEST_CASE("masses and inertias that no body can have are refused by the body's name") {
  CHECK(refusal(Mistake::negative_mass) == "body table: its mass is -1 kg");
  CHECK(refusal(Mistake::no_mass) ==
        "body table: the principal moments of its inertia are 0.1, 0.1 and 0.2 kg m^2, but its mass is 0; give it a mass, or no inertia");
  CHECK(refusal(Mistake::inertia_impossible) ==
        "body table: the principal moments of its inertia are 0.1, 0.1 and 0.3 kg m^2, and the largest cannot exceed the sum of the other "
        "two; is a unit wrong, or are transverse and axial inertia exchanged?");
}

TEST_CASE("joints and quantities need names, each its own") {
  CHECK(refusal(Mistake::joint_unnamed) == "joint 2 has no name");
  CHECK(refusal(Mistake::joints_alike) == "joint 2 and joint 4 are both called A1; each needs a name of its own");
  CHECK(refusal(Mistake::quantities_alike) == "coordinate 1 and actuator 1 are both called alpha; each needs a name of its own");
}

TEST_CASE("a shape that cannot be drawn is refused by the body's name") {
  CHECK(refusal(Mistake::shape_unknown) == "body table: a shape of unknown kind 7");
  CHECK(refusal(Mistake::shape_not_finite) == "body table: a shape whose places or radius are not finite numbers");
}
