#include <core/mechanics/model/differences.hpp>

#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

TEST_CASE("jets and differences agree to the digits that differences in extended precision have") {
  std::mt19937_64 random(61);
  for (const pm_mechanism* table : {&test::hexapod(), &test::four_bar(), &test::arm(), &test::slider_crank()}) {
    const Machine machine = test::make(*table);
    for (int k = 0; k < 50; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      INFO(table->name << ", q = " << motion.q.transpose());
      const Deviation d = jets_against_differences(machine, motion.state(machine));
      CHECK(d.reachable);
      CHECK(d.rate < 1e-13);
      CHECK(d.acceleration < 1e-11);
    }
  }
}

TEST_CASE("a jet that is wrong by a millionth is found") {
  const Machine machine = test::make(test::arm());
  std::mt19937_64 random(62);
  const test::Motion motion = test::random_motion(machine, random);
  for (const std::size_t component : {1u, 2u}) {
    State s = motion.state(machine);
    // The boom's rotation, element (0, 0): it moves with theta.
    const std::size_t scalar = machine.layout().body(1) + 3;
    s.placement_jets[3 * scalar + component] += 1e-6;
    const Deviation d = jets_against_differences(machine, s);
    CHECK((component == 1 ? d.rate : d.acceleration) > 1e-8);
    CHECK((component == 1 ? d.acceleration : d.rate) < 1e-11);
  }
}

TEST_CASE("near the edge of reach the stencil is small enough to stay within it, and knows what it is good for") {
  const Machine machine(test::slider_crank(), {{12}, {0.2}, {0.5}});  // the fault "reach": the crank has room from 0.75 to 0.85 rad
  const double edge[] = {0.8499999}, rate[] = {1.0}, none[] = {0.0};
  State s;
  evaluate(machine, edge, rate, none, s);
  REQUIRE(s.status == PM_OK);
  const Deviation d = jets_against_differences(machine, s);
  REQUIRE(d.reachable);
  // Steps below 2.5e-8 rad: second differences of numbers with 64 bits keep four digits or fewer.
  CHECK(d.acceleration_error > 1e-6);
  CHECK(d.acceleration <= d.acceleration_error);
  CHECK(d.rate <= std::max(1e-11, d.rate_error));
}

TEST_CASE("a stencil that leaves the reach however small it is compares nothing and says so") {
  const Machine machine(test::slider_crank(), {{12}, {0.2}, {0.5}});
  const double edge[] = {0.85}, rate[] = {1.0}, none[] = {0.0};
  State s;
  evaluate(machine, edge, rate, none, s);
  REQUIRE(s.status == PM_OK);
  CHECK_FALSE(jets_against_differences(machine, s).reachable);
}

TEST_CASE("what is known of jets and differences at a sound pose is far below what is asked of them") {
  std::mt19937_64 random(63);
  const Machine machine = test::make(test::hexapod());
  for (int k = 0; k < 20; ++k) {
    const Deviation d = jets_against_differences(machine, test::random_motion(machine, random).state(machine));
    CHECK(d.rate_error < 1e-12);
    CHECK(d.acceleration_error < 1e-10);
  }
}

TEST_CASE("at rest there is nothing to compare") {
  const Machine machine = test::make(test::arm());
  const double q[] = {0.1, 0.3, 0.2}, none[] = {0, 0, 0};
  State s;
  evaluate(machine, q, none, none, s);
  const Deviation d = jets_against_differences(machine, s);
  CHECK(d.reachable);
  CHECK(d.rate == 0);
  CHECK(d.acceleration == 0);
}
