// Inverse and forward displacement, velocity and acceleration of the 4SPS-SPR undo each other, and a forward solution never slips into
// another assembly mode unnoticed.
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/four_sps_spr.hpp>

#include <catch2/catch.hpp>
#include <random>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::VectorXd;

namespace {

VectorXd random_vector(const Machine& machine, std::mt19937_64& random, bool in_box) {
  VectorXd v(machine.dof());
  for (int i = 0; i < v.size(); ++i) {
    const Range& box = machine.topology().coordinates[static_cast<std::size_t>(i)].box;
    v(i) = in_box ? std::uniform_real_distribution(box.min, box.max)(random) : std::uniform_real_distribution(-1.0, 1.0)(random);
  }
  return v;
}

VectorXd actuators_at(const Machine& machine, const VectorXd& q) {
  const Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(pose.status == PM_OK);
  return Eigen::Map<const VectorXd>(pose.numbers.data() + machine.layout().actuator(0), machine.dof());
}

ClosedForm closed_form_at(const Machine& machine, const VectorXd& q) {
  const VectorXd zero = VectorXd::Zero(machine.dof());
  State s;
  evaluate(machine, q.data(), zero.data(), zero.data(), s);
  REQUIRE(s.status == PM_OK);
  return closed_form(machine, s, characteristic_length(machine));
}
double determinant_of_closed_form(const Machine& machine, const VectorXd& q) { return closed_form_at(machine, q).determinant; }

}  // namespace

TEST_CASE("forward velocity and acceleration of the 4SPS-SPR undo the inverse") {
  const Machine machine = test::make_four_sps_spr();
  std::mt19937_64 random(81);
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = random_vector(machine, random, true), rate = random_vector(machine, random, false),
                   acceleration = random_vector(machine, random, false);
    CAPTURE(q.transpose(), rate.transpose(), acceleration.transpose());
    State s;
    evaluate(machine, q.data(), rate.data(), acceleration.data(), s);
    REQUIRE(s.status == PM_OK);
    const ClosedForm c = closed_form(machine, s, characteristic_length(machine));
    const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];
    // Rounding times the condition number, which at home is 182 already.
    const double tolerance = 1e-14 * c.condition;
    CHECK((forward_velocity(c, actuator_rates(s)) - platform.twist()).norm() < tolerance * (1 + platform.twist().norm()));
    CHECK((forward_acceleration(c, actuator_accelerations(s), platform.twist()) - platform.twist_rate()).norm() <
          tolerance * (1 + platform.twist_rate().norm()));
  }
}

TEST_CASE("a pose of the 4SPS-SPR is found again from its limbs, from a guess a centimetre away") {
  for (const test::Dependent dependent : {test::x, test::y, test::alpha, test::beta, test::gamma}) {
    const Machine machine = test::make_four_sps_spr(dependent);
    ForwardSolver solver(machine);
    std::mt19937_64 random(82);
    int solved = 0;
    for (int k = 0; k < 400; ++k) {
      const VectorXd q = random_vector(machine, random, true);
      // The condition number is 182 at home. At 500 a singular surface is some two thousandths of the size away, and with it the other
      // solution: a guess a centimetre off may well be nearer to that one.
      if (machine.pose({q.data(), 5}).status != PM_OK || closed_form_at(machine, q).condition > 500) continue;
      const VectorXd guess = q + 0.01 * random_vector(machine, random, false).normalized();
      CAPTURE(test::pose_names[dependent], q.transpose(), guess.transpose());
      const ForwardSolution s = solver.solve(actuators_at(machine, q), guess);
      REQUIRE(s.outcome == Outcome::good);
      CHECK((s.coordinates - q).lpNorm<Eigen::Infinity>() < 1e-10);  // limbs to 1e-14, times the condition, with two digits to spare
      ++solved;
    }
    CHECK(solved >= 200);
  }
}

TEST_CASE("the whole box is reached from home by continuation") {
  const Machine machine = test::make_four_sps_spr();
  std::mt19937_64 random(83);
  const VectorXd home = machine.home();
  for (int k = 0; k < 50; ++k) {
    const VectorXd q = random_vector(machine, random, true);
    CAPTURE(q.transpose());
    std::vector<VectorXd> actuators;
    for (int step = 1; step <= 20; ++step) actuators.push_back(actuators_at(machine, home + step / 20.0 * (q - home)));
    const std::vector<ForwardSolution> way = follow_actuators(machine, actuators, home);
    REQUIRE(way.size() == actuators.size());
    CHECK(way.back().outcome == Outcome::good);
    CHECK((way.back().coordinates - q).lpNorm<Eigen::Infinity>() < 1e-9);
  }
}

TEST_CASE("det G is positive at home and changes its sign on known singular surfaces") {
  const Machine machine = test::make_four_sps_spr();
  const VectorXd home = machine.home();
  CHECK(determinant_of_closed_form(machine, home) > 0);
  const auto crossing = [&](int coordinate, double from, double to) {
    const auto at = [&](double angle) {
      VectorXd q = home;
      q(coordinate) = angle * deg;
      return determinant_of_closed_form(machine, q);
    };
    REQUIRE(at(from) * at(to) < 0);
    for (int i = 0; i < 50; ++i) (at(from) * at(0.5 * (from + to)) > 0 ? from : to) = 0.5 * (from + to);
    return from;
  };
  enum { alpha = 2, beta = 3, gamma = 4 };
  // Degrees, from the paper's Equations (5) and (10) programmed apart from this project.
  constexpr double last_digit = 0.0005;
  CHECK(crossing(alpha, 0, 25) == Approx(17.604).margin(last_digit));
  CHECK(crossing(beta, 0, 15) == Approx(9.595).margin(last_digit));
  CHECK(crossing(beta, 15, 30) == Approx(22.853).margin(last_digit));
  CHECK(crossing(beta, 0, -60) == Approx(-44.356).margin(last_digit));
  CHECK(crossing(gamma, 0, -60) == Approx(-52.767).margin(last_digit));
  CHECK(crossing(gamma, 0, 60) == Approx(51.753).margin(last_digit));
}

TEST_CASE("a target beyond a singular surface is told as such, or solved on this side: never taken across") {
  const Machine machine = test::make_four_sps_spr();
  ForwardSolver solver(machine);
  const VectorXd home = machine.home();
  int targets = 0, this_side = 0, other = 0, none = 0;
  std::mt19937_64 random(84);
  for (int k = 0; k < 400; ++k) {
    VectorXd q = random_vector(machine, random, true);
    q(2) = std::uniform_real_distribution(18 * deg, 40 * deg)(random);
    if (machine.pose({q.data(), 5}).status != PM_OK || determinant_of_closed_form(machine, q) >= 0) continue;
    ++targets;
    CAPTURE(q.transpose());
    const VectorXd l = actuators_at(machine, q);
    const ForwardSolution s = solver.solve(l, home);
    if (s.outcome == Outcome::good) {  // another pose with the same limbs, on the guess's side
      CHECK(determinant_of_closed_form(machine, s.coordinates) > 0);
      CHECK((actuators_at(machine, s.coordinates) - l).lpNorm<Eigen::Infinity>() < 1e-11);
      ++this_side;
    } else {
      CHECK_FALSE(s.why.empty());
      s.outcome == Outcome::other_assembly_mode ? ++other : ++none;
    }
  }
  CAPTURE(targets, this_side, other, none);
  CHECK(targets >= 100);
  CHECK(other > 0);
  CHECK(this_side > 0);
}

TEST_CASE("limbs that no pose has are refused with a sentence") {
  const Machine machine = test::make_four_sps_spr();
  ForwardSolver solver(machine);
  VectorXd l = actuators_at(machine, machine.home());
  l(0) = 3.0;  // limb 1 three metres long and the others as they are: the platform would have to be torn apart
  const ForwardSolution s = solver.solve(l, machine.home());
  CHECK(s.outcome == Outcome::not_converged);
  CHECK_THAT(s.why, Catch::StartsWith("no pose near the guess has these actuator values"));
  CHECK(s.residual > 0.1);
  CHECK(std::isfinite(s.residual));
  CHECK(s.coordinates.allFinite());
}
