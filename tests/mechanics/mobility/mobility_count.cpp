#include <core/mechanics/mobility/mobility_count.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

State at_home(const Machine& machine) { return state_at_rest(machine, machine.home()); }

}  // namespace

TEST_CASE("a planar four-bar moves in one way and has three constraints more than it needs") {
  const Machine machine = test::make(test::four_bar());
  const Mobility m = mobility(machine, at_home(machine));
  CHECK(m.bodies == 4);
  CHECK(m.joints == 4);
  CHECK(m.freedoms_sum == 4);
  CHECK(m.gruebler == -2);  // which is why a count alone does not do
  CHECK(m.rows == 20);
  CHECK(m.rank == 17);
  CHECK(m.freedoms == 1);
  CHECK(m.idle == 0);
  CHECK(m.redundant == 3);
}

TEST_CASE("six limbs between balls spin idly, between universal joints and balls they do not") {
  const Machine balls = test::make_hexapod(test::BaseJoint::ball);
  const Mobility spinning = mobility(balls, at_home(balls));
  CHECK(spinning.gruebler == 6);
  CHECK(spinning.freedoms == 6);
  CHECK(spinning.idle == 6);
  CHECK(spinning.redundant == 0);
  CHECK(spinning.rows == 6 * (3 + 5 + 3));

  const Machine crosses = test::make_hexapod(test::BaseJoint::universal);
  const Mobility still = mobility(crosses, at_home(crosses));
  CHECK(still.gruebler == 6);
  CHECK(still.freedoms == 6);
  CHECK(still.idle == 0);
  CHECK(still.redundant == 0);
  CHECK(still.rows == 6 * (4 + 5 + 3));
}

TEST_CASE("mobility counts a serial arm and a spatial slider-crank") {
  const Machine arm = test::make(test::arm());
  const Mobility a = mobility(arm, at_home(arm));
  CHECK(a.freedoms == 3);
  CHECK(a.idle == 0);
  CHECK(a.redundant == 0);
  const Machine crank = test::make(test::slider_crank());
  const Mobility c = mobility(crank, at_home(crank));
  CHECK(c.freedoms == 1);
  CHECK(c.idle == 1);
  CHECK(c.redundant == 0);
}
