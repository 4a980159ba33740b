// Prescribed actuators, proved, where the answers are known by hand: the slider-crank, and programs of one coordinate.
#include <tests/analysis/proof_followed.hpp>

#include <core/analysis/proof/followed_krawczyk.hpp>
#include <core/program/recorder.hpp>
#include <tests/given/slider_crank.hpp>

using namespace trial;
using analysis::Krawczyk, analysis::Offsets;
using Catch::Contains;

namespace {

// Where the slider of a crank at `theta` is, by the formula of slider_crank.hpp.
long double slider(long double theta) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const Vector e = test::SliderCrank::e().cast<long double>(), pin(0.2 * std::cos(theta), 0.2 * std::sin(theta), 0.0L);
  const Vector f = pin - test::SliderCrank::c0().cast<long double>();
  const long double along = e.dot(f);
  return along + std::sqrt(0.5L * 0.5L - f.dot(f) + along * along);
}
// The crank angle between two, between which the slider only rises or only falls, at which it is at `s`.
long double crank(long double s, long double low, long double high) {
  const bool rises = slider(high) > slider(low);
  for (int k = 0; k < 200; ++k) {
    const long double middle = 0.5L * (low + high);
    ((slider(middle) < s) == rises ? low : high) = middle;
  }
  return 0.5L * (low + high);
}
// The dead centre below the crank's home, where the slider is farthest out.
long double dead_centre() {
  long double low = -1.5L, high = 0.8L;
  for (int k = 0; k < 300; ++k) {
    const long double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (slider(a) < slider(b) ? low : high) = slider(a) < slider(b) ? a : b;
  }
  return 0.5L * (low + high);
}

std::unique_ptr<Machine> slider_crank() {
  const pm_mechanism& table = test::slider_crank();
  return std::make_unique<Machine>(table, mechanics::default_values(mechanics::describe(table)));
}
Sines slider_law(const Machine& machine, double amplitude) {
  return {{{machine.home_pose().numbers[machine.layout().actuator(0)], amplitude, 1, false}}};
}

// A program of one coordinate x.
template <class F>
analysis::ActuatorGeometry geometry_of(F&& f) {
  program::Recorder recorder(1);
  const Recorded x = recorder.input(0);
  const std::vector<Recorded> out{f(x)};
  return analysis::ActuatorGeometry(recorder.finish(out), 0);
}

// x at rest with the actuator at `value`, near `nearby`: what is found in the solution's surroundings of `half`, and as much again.
struct Rest {
  Krawczyk::Found found{};
  Bounds only, within;
};
Rest find_at_rest(const analysis::ActuatorGeometry& geometry, double value, double nearby, double half) {
  const linear::SmallVector sizes = linear::SmallVector::Ones(1);
  analysis::FrameFinder frames(geometry, sizes);
  Krawczyk krawczyk(geometry, sizes);
  const Bounded law{Bounds::exactly(value), Bounds::exactly(0), Bounds::exactly(0)};
  const auto frame = frames.at(0, &law, linear::SmallVector::Constant(1, nearby));
  REQUIRE(frame);
  Offsets include, only, within;
  include.fill({-half, half});
  int rounds = 0;
  Rest out;
  out.found = krawczyk.find(*frame, {-1, 1}, {&law, &law}, include, only, within, rounds);
  out.only = {frame->origin(0) + only[0].low, frame->origin(0) + only[0].high};
  out.within = {frame->origin(0) + within[0].low, frame->origin(0) + within[0].high};
  return out;
}

}  // namespace

TEST_CASE("a slider that pushes its crank to the dead centre is proved up to shortly before it, and no further") {
  const auto machine = slider_crank();
  const Followed motion(*machine, slider_law(*machine, 0.2), 1.5, 301);
  REQUIRE_FALSE(motion.trajectory.ending.empty());
  const long double centre = dead_centre(), home = slider(0.8L), farthest = slider(centre);
  const auto dead = static_cast<double>(std::asin((farthest - home) / 0.2L));  // time
  const FollowedProof proof = motion.proof();
  REQUIRE(proof.over);
  CHECK(proof.proved.low == 0);
  CHECK(proof.proved.high <= dead);
  CHECK(proof.proved.high > dead - 1e-5);
  CHECK_THAT(proof.reason, Contains("singular surface"));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int k = 0; k < 200; ++k) {
    const double left = dead * std::pow(10, -4 * uniform(random)), t = std::max(0.0, dead - left);
    Bounded b;
    REQUIRE(proof.over({std::max(0.0, t - 0.1 * left * uniform(random)), t + 0.1 * left * uniform(random)}, &b));
    const long double theta = crank(home + 0.2L * std::sin(static_cast<long double>(t)), centre, 1.5L);
    CAPTURE(t);
    CHECK(b.value.low <= theta);
    CHECK(theta <= b.value.high);
  }
}

TEST_CASE("a mechanism that does not record its geometry is not proved to follow its actuators, and says why") {
  pm_mechanism older = test::slider_crank();
  older.struct_size = offsetof(pm_mechanism, record);
  const Machine machine(older, mechanics::default_values(mechanics::describe(older)));
  const Sines law = slider_law(machine, 0.01);
  const Trajectory path = mechanics::followed(machine, law.path(), even(1, 11), machine.home()).trajectory;
  const FollowedProof proof = prove_followed(machine, path, law.over());
  CHECK_FALSE(proof.over);
  CHECK(proof.proved == Bounds{0, 0});
  CHECK_THAT(proof.reason, Contains("the plugin was built before geometry was recorded"));
}

TEST_CASE("a path on another assembly mode is proved as what it is, and not taken for this one") {
  const auto machine = slider_crank();
  const long double centre = dead_centre(), home = slider(0.8L);
  const Sines law = slider_law(*machine, 0.01);
  const auto other = [&](double t) { return crank(home + 0.01L * std::sin(static_cast<long double>(t)), centre - 1.2L, centre); };
  const Followed here(*machine, law, 3, 31);
  const Followed there(*machine, law, 3, 31, Eigen::VectorXd::Constant(1, static_cast<double>(other(0))));
  const FollowedProof proof = there.proof();
  REQUIRE(proof.reason == "");
  for (const double t : {0.0, 0.7, 2.9}) {
    Bounded b;
    REQUIRE(proof.over({t, t + 0.1}, &b));
    CHECK(b.value.low <= other(t));
    CHECK(other(t) <= b.value.high);
    CHECK_FALSE(b.value.has(here.at(t)(0)));
  }
  // One that changes over between two samples.
  Followed both = here;
  both.trajectory.value.bottomRows(16) = there.trajectory.value.bottomRows(16);
  both.trajectory.at = [&](double t, double* q, double* rate, double* acceleration) {
    return (t < 1.5 ? here : there).trajectory.at(t, q, rate, acceleration);
  };
  const FollowedProof half = both.proof();
  CHECK(half.proved.high < 1.5);
  CHECK(half.proved.high > 1.4);
  CHECK_THAT(half.reason, Contains("the path that was followed is not where these actuators lead"));
}

TEST_CASE("a box with one solution at every instant is told from one with two, and from one with none") {
  const auto square_of = geometry_of([](const Recorded& x) { return x * x; });
  const Rest one = find_at_rest(square_of, 4, 1.9, 0.2);
  CHECK(one.found == Krawczyk::Found::one);
  CHECK(one.within.has(2));
  CHECK(one.within.width() < 0.2);
  CHECK(find_at_rest(square_of, 0.01, 0.12, 0.25).found == Krawczyk::Found::undecided);  // 0.1 and -0.1
  // Its box moved aside holds none: what would be left of it is empty.
  const linear::SmallVector sizes = linear::SmallVector::Ones(1);
  analysis::FrameFinder frames(square_of, sizes);
  Krawczyk krawczyk(square_of, sizes);
  const Bounded law{Bounds::exactly(4), Bounds::exactly(0), Bounds::exactly(0)};
  const auto frame = frames.at(0, &law, linear::SmallVector::Constant(1, 1.9));
  REQUIRE(frame);
  Offsets aside;
  aside.fill({0.1, 0.2});
  CHECK_FALSE(krawczyk.contract(*frame, {-1, 1}, {&law, &law}, aside));
  aside.fill({-0.1, 0.2});
  CHECK(krawczyk.contract(*frame, {-1, 1}, {&law, &law}, aside));
  CHECK(aside[0].has(0));
  CHECK(aside[0].width() < 1e-9);
}

TEST_CASE("what is continuous with a kink is proved through it: what jumps is not") {
  const auto kinked = geometry_of([](const Recorded& x) { return x + 0.1 * abs(x - 1.0); });
  CHECK(kinked.kinks == 1);
  const Rest kink = find_at_rest(kinked, 1.01, 1.05, 0.1);  // 1.1 x - 0.1 = 1.01
  CHECK(kink.found == Krawczyk::Found::one);
  CHECK(kink.within.low <= 1.11 / 1.1);
  CHECK(1.11 / 1.1 <= kink.within.high);

  // x, and x - 0.3 beyond 1: 0.9 is there twice, and the partials, 1 everywhere, do not tell.
  const auto jumping = geometry_of([](const Recorded& x) { return choose(x < 1.0, x, x - 0.3); });
  CHECK(find_at_rest(jumping, 0.9, 0.9, 0.02).found == Krawczyk::Found::one);
  CHECK(find_at_rest(jumping, 0.9, 0.9, 0.1).found == Krawczyk::Found::no_bounds);

  // An angle that goes round at pi: its partials do not tell either.
  const auto round = geometry_of([](const Recorded& x) { return atan2(sin(x), cos(x)); });
  CHECK(find_at_rest(round, 3.0, 3.0, 0.05).found == Krawczyk::Found::one);
  CHECK(find_at_rest(round, 3.0, 3.0, 0.15).found == Krawczyk::Found::no_bounds);
}
