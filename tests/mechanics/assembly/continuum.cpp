// Modes that are not isolated, on two legs in a plane, whose modes are where two circles meet, and on angles that are singular.
#include <tests/given/two_legs.hpp>
#include <tests/mechanics/assembly/actuators_at.hpp>
#include <tests/mechanics/mechanisms.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using test::actuators_at, test::modes_at, test::shortly;

namespace {

Machine two_legs(double apart) { return Machine(test::two_legs(), {{apart}}); }

}  // namespace

TEST_CASE("two circles that meet twice give two modes, neither of them double") {
  const Machine machine = two_legs(0.3);
  const AssemblyModes found = modes_at(machine, Eigen::Vector2d(0.1, 0.2));
  REQUIRE(found.modes.size() == 2);
  CHECK(found.continua.empty());
  for (const AssemblyMode& m : found.modes) {
    CHECK_FALSE(m.twofold);
    CHECK(m.coordinates(0) == Approx(0.1).epsilon(1e-12));
    CHECK(std::abs(m.coordinates(1)) == Approx(0.2).epsilon(1e-12));
  }
}

TEST_CASE("two circles that touch give one mode, and it is double") {
  const Machine machine = two_legs(0.3);
  for (const double x : {0.12, -0.1, 0.45}) {  // between the centres, and to either side of both
    CAPTURE(x);
    const AssemblyModes found = modes_at(machine, Eigen::Vector2d(x, 0));
    REQUIRE(found.modes.size() == 1);
    CHECK(found.modes[0].twofold);
    CHECK(found.continua.empty());
    // The circles part as the square of y: within the error that a mode may have, 1e-10 of its size, lies 1e-5 of it.
    CHECK(std::abs(found.modes[0].coordinates(1)) < 2e-5);
    CHECK(found.modes[0].coordinates(0) == Approx(x).epsilon(1e-9));
  }
}

TEST_CASE("two circles that all but touch give two modes close together") {
  const Machine machine = two_legs(0.3);
  for (const double y : {1e-2, 1e-3, 1e-4}) {
    CAPTURE(y);
    const AssemblyModes found = modes_at(machine, Eigen::Vector2d(0.12, y));
    REQUIRE(found.modes.size() == 2);
    for (const AssemblyMode& m : found.modes) {
      CHECK_FALSE(m.twofold);
      CHECK(std::abs(m.coordinates(1)) == Approx(y).epsilon(1e-4));
    }
  }
}

TEST_CASE("two circles that are one give no isolated mode, but a closed curve of poses") {
  const Machine machine = two_legs(0);
  const Eigen::Vector2d q(0.1, 0.2);
  const AssemblyModes found = modes_at(machine, q);
  CHECK(found.modes.empty());
  REQUIRE(found.continua.size() == 1);
  const ModeContinuum& c = found.continua[0];
  CHECK(c.dimension == 1);
  CHECK(c.closed);
  CHECK(c.whole);
  CHECK(c.distance < 1e-12);
  CHECK(c.poses.size() == c.coordinates.size());
  for (const Eigen::VectorXd& p : c.coordinates) CHECK(std::abs(p.norm() - q.norm()) < 1e-10 * q.norm());
  // From a pose to about the other end of the diameter. Steps are a tenth of the size at most, so an end is missed by half of one, an angle
  // of a quarter at this radius: less than its square in the length.
  CHECK(c.extent <= 2 * q.norm() * (1 + 1e-12));
  CHECK(c.extent > 2 * q.norm() * (1 - 0.25 * 0.25));
  CHECK(c.reached_by_starts > 0);
  // The poses go once round: each direction is close to one of them.
  for (double angle = 0; angle < 6.2; angle += 0.1) {
    const Eigen::Vector2d there = q.norm() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    double nearest = 1;
    for (const Eigen::VectorXd& p : c.coordinates) nearest = std::min(nearest, (p - there).norm());
    CHECK(nearest < 0.3 * q.norm());
  }
}

TEST_CASE("where the angles are singular the mechanism is not, and the mode is neither double nor one of a continuum") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  Eigen::VectorXd q = machine.home();
  q(4) = std::numbers::pi / 2;  // Rz(alpha) Ry(beta) Rx(gamma): alpha and gamma turn about one axis
  q(0) = 0.05, q(1) = -0.03;
  const AssemblyModes found = modes_at(machine, q);
  REQUIRE_FALSE(found.modes.empty());
  CHECK(found.modes.front().distance < 1e-7);
  CHECK(found.modes.front().chart);
  CHECK_FALSE(found.modes.front().twofold);
  CHECK(found.continua.empty());
}

TEST_CASE("how a search ended is told") {
  const Machine machine = two_legs(0.3);
  const Eigen::Vector2d q(0.1, 0.2);
  CHECK(modes_at(machine, q).ended == AssemblyModes::Ended::quiet);
  AssemblyOptions few = shortly();
  few.most_starts = 10;
  CHECK(find_assembly_modes(machine, actuators_at(machine, q), q, few).ended == AssemblyModes::Ended::most_starts);
  few = shortly();
  few.most_modes = 1;
  const AssemblyModes one = find_assembly_modes(machine, actuators_at(machine, q), q, few);
  CHECK(one.ended == AssemblyModes::Ended::most_modes);
  CHECK_FALSE(one.complete_search());
  CHECK(one.modes.size() == 1);
}
