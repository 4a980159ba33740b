#include <core/mechanics/displacement/displacement.hpp>

#include <core/mechanics/model/closed_form.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

SmallVector actuator_values(const Machine& machine, const Eigen::VectorXd& q) {
  const Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(pose.status == PM_OK);
  return Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + machine.layout().actuator(0), machine.dof());
}

double determinant(const Machine& machine, const SmallVector& q) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(machine.dof());
  State s;
  evaluate(machine, q.data(), zero.data(), zero.data(), s);
  REQUIRE(s.status == PM_OK);
  return closed_form(machine, s, 1.0).determinant;
}

}  // namespace

TEST_CASE("a hexapod's pose is found again from its limbs, from home and from nearby") {
  const Machine machine = test::make(test::hexapod());
  ForwardSolver solver(machine);
  std::mt19937_64 random(51);
  for (int k = 0; k < 200; ++k) {
    const Eigen::VectorXd q = test::random_motion(machine, random).q;
    CAPTURE(q.transpose());
    const SmallVector l = actuator_values(machine, q);
    const Eigen::VectorXd nearby = q + 0.01 * Eigen::VectorXd::Ones(6);
    const SmallVector home = machine.home();
    for (const SmallVector& guess : {SmallVector(nearby), home}) {
      const ForwardSolution s = solver.solve(l, guess);
      REQUIRE(s.outcome == Outcome::good);
      CHECK(s.why.empty());
      CHECK((s.coordinates - q).lpNorm<Eigen::Infinity>() < 1e-12);  // condition about 10, limbs to 1e-14
      CHECK(s.iterations <= 20);
    }
  }
}

TEST_CASE("a slider-crank has a pose on either side of its dead centre, and the guess's side is kept") {
  const Machine machine = test::make(test::slider_crank());
  ForwardSolver solver(machine);
  const SmallVector s = actuator_values(machine, Eigen::VectorXd::Constant(1, 1.2));
  std::vector<double> found;
  for (double guess = -3.1; guess < 3.1; guess += 0.05) {
    CAPTURE(guess);
    const SmallVector start = SmallVector::Constant(1, guess);
    const ForwardSolution r = solver.solve(s, start);
    REQUIRE(r.outcome == Outcome::good);
    CHECK(determinant(machine, r.coordinates) * determinant(machine, start) > 0);
    CHECK((actuator_values(machine, r.coordinates) - s).norm() < 1e-12);
    const double turns = std::remainder(r.coordinates(0), 2 * std::numbers::pi);
    if (std::none_of(found.begin(), found.end(), [&](double x) { return std::abs(x - turns) < 1e-9; })) found.push_back(turns);
  }
  std::sort(found.begin(), found.end());
  REQUIRE(found.size() == 2);
  CHECK(found.back() == Approx(1.2).epsilon(1e-12));
  CHECK(determinant(machine, SmallVector::Constant(1, found.front())) * determinant(machine, SmallVector::Constant(1, 1.2)) < 0);
}

TEST_CASE("actuator values that no pose has are refused with the nearest approach") {
  const Machine machine = test::make(test::slider_crank());
  ForwardSolver solver(machine);
  const ForwardSolution r = solver.solve(SmallVector::Constant(1, 2.0), machine.home());  // the slider cannot be 2 m out
  CHECK(r.outcome == Outcome::not_converged);
  CHECK_FALSE(r.why.empty());
  CHECK(std::isfinite(r.residual));
  CHECK(r.residual > 1);
  CHECK(std::isfinite(r.coordinates(0)));
}

TEST_CASE("a guess that cannot be assembled is refused as such") {
  const Machine machine(test::slider_crank(), {{0}, {0.4}, {0.35}});
  ForwardSolver solver(machine);
  const ForwardSolution r = solver.solve(SmallVector::Constant(1, 0.3), SmallVector::Constant(1, -1.5));
  CHECK(r.outcome == Outcome::not_converged);
  CHECK(r.why == "the guess itself cannot be assembled");
}

TEST_CASE("a sequence is followed from each solution to the next, and stops where it fails") {
  const Machine machine = test::make(test::hexapod());
  std::vector<Eigen::VectorXd> poses, actuators;
  for (int k = 0; k <= 20; ++k) {
    const double t = 0.05 * k;
    Eigen::VectorXd q(6);
    q << 0.08 * t, -0.05 * t, 0.6 + 0.05 * t * t, 0.2 * t, -0.1 * t, 0.15 * t;
    poses.push_back(q);
    actuators.push_back(actuator_values(machine, q));
  }
  const std::vector<ForwardSolution> followed = follow_actuators(machine, actuators, machine.home());
  REQUIRE(followed.size() == poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    CAPTURE(k);
    CHECK(followed[k].outcome == Outcome::good);
    CHECK((followed[k].coordinates - poses[k]).lpNorm<Eigen::Infinity>() < 1e-12);
  }
  actuators[7](0) = 5.0;  // one limb alone
  const std::vector<ForwardSolution> stopped = follow_actuators(machine, actuators, machine.home());
  REQUIRE(stopped.size() == 8);
  CHECK(stopped.back().outcome != Outcome::good);
}
