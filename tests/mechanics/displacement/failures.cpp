// Forward displacement where there is no answer: each way to fail has its outcome and its sentence.
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/displacement/follow.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <pmreport/mechanism.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Catch::Contains;

namespace {

// A slide at x = u^2, driven; u reaches to 0.5. At u = 0 the drive does not move with u.
class Cam : public Mechanism<1> {
 public:
  static constexpr const char *name = "cam", *title = "cam", *source = "this test";
  static constexpr std::array<Parameter, 0> parameters{};
  explicit Cam(const Parameters&) {}
  Topology topology() const {
    Topology t;
    t.coordinates = {{"u", "parameter", "m", 0.3, {0.1, 0.4}}};
    t.platform = t.add(Body{"slide", 0, false, {}});
    t.add(Joint{"P", JointKind::prismatic, 0, 1, {}});
    t.add(Actuator{"x", "place", "m", 0, {-1, 1}});
    for (const char* n : {"c1", "c2", "c3", "c4", "c5"}) t.constraints.push_back({n, n, "N"});
    return t;
  }
  template <class T>
  void place(const Coordinates<T>& q, Placement<T>& at) const {
    at.require(0.5 - q[0], "the cam ends");
    const Vector3<T> here(square(q[0]), T(0.0), T(0.0));
    at.body(1, here, Matrix3<T>(Matrix3<T>::Identity()));
    at.joint(0, here, Eigen::Vector3d::UnitX().cast<T>());
    at.actuator(0, here(0));
  }
  template <class T>
  Matrix6<T> jacobian(const Placement<T>&) const {
    return Matrix6<T>::Identity();
  }
};

ForwardSolution solve(double actuator, double guess) {
  const Machine machine = test::make(contract::mechanism<Cam>);
  return ForwardSolver(machine).solve(SmallVector::Constant(1, actuator), SmallVector::Constant(1, guess));
}

}  // namespace

TEST_CASE("a cam's parameter is found from its slide") {
  const ForwardSolution s = solve(0.16, 0.3);
  CHECK(s.outcome == Outcome::good);
  CHECK(s.coordinates(0) == Approx(0.4));
}

TEST_CASE("a guess at which neither actuator nor platform move with the coordinate is refused, and the coordinate is named") {
  const ForwardSolution s = solve(0.16, 0.0);
  CHECK(s.outcome == Outcome::singular);
  CHECK(s.why == "u does not move the platform there: this coordinate is singular, the machine is not");
  CHECK(s.coordinates(0) == 0);
  CHECK(s.residual == Approx(0.16));
}

TEST_CASE("a solution beyond the poses that can be assembled is not reached: the best before the edge is told") {
  const ForwardSolution s = solve(0.36, 0.1);  // u = 0.6
  CHECK(s.outcome == Outcome::not_converged);
  CHECK(s.why == "the way to these actuator values leaves the poses that can be assembled");
  CHECK(s.coordinates(0) <= 0.5);
  CHECK(s.coordinates(0) > 0.49);
}

TEST_CASE("actuator values that no pose has end after a bounded number of tries, with the nearest approach") {
  const ForwardSolution s = solve(-0.01, 0.3);                                     // squares are not negative
  CHECK((s.outcome == Outcome::not_converged || s.outcome == Outcome::singular));  // squares are least where u is singular
  CHECK(s.iterations <= ForwardSolver::max_iterations);
  CHECK_FALSE(s.why.empty());
  CHECK(s.residual >= 0.01);
}

TEST_CASE("a solution on the other side of a singular surface is of another assembly mode, and said to be") {
  // From guesses turned far out of the way Newton sometimes comes to a pose with the same limbs and the other sign of det G.
  const Machine machine = test::make(test::hexapod());
  ForwardSolver solver(machine);
  const SmallVector home = machine.home(), limbs = actuators_at(machine, home);
  const auto determinant = [&](const SmallVector& q) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(6);
    State s;
    evaluate(machine, q.data(), zero.data(), zero.data(), s);
    REQUIRE(s.status == PM_OK);
    return closed_form(machine, s, 1.0).determinant;
  };
  std::mt19937_64 random(52);
  std::uniform_real_distribution<double> turn(-2.5, 2.5);
  int same = 0, other = 0;
  for (int k = 0; k < 300; ++k) {
    SmallVector guess = home;
    for (int i = 3; i < 6; ++i) guess(i) += turn(random);
    CAPTURE(guess.transpose());
    const ForwardSolution s = solver.solve(limbs, guess);
    if (s.outcome == Outcome::not_converged) {
      CHECK_FALSE(s.why.empty());
      continue;
    }
    CHECK((actuators_at(machine, s.coordinates) - limbs).lpNorm<Eigen::Infinity>() < 1e-12);
    const bool crossed = determinant(guess) * determinant(s.coordinates) < 0;
    CHECK(crossed == (s.outcome == Outcome::other_assembly_mode));
    if (crossed) CHECK_THAT(s.why, Contains("belongs to another assembly mode"));
    ++(crossed ? other : same);
  }
  CHECK(same > 0);
  CHECK(other > 0);
}
