// Prescribed actuators: the coordinates that must follow are known beforehand, since the actuators are taken from a motion of coordinates.
#include <core/mechanics/displacement/follow.hpp>

#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>
#include <cmath>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {

// The actuators along a motion of coordinates.
Drive drive_of(const Machine& machine, const test::Motion& motion) {
  return [&machine, motion](double t, double* value, double* rate, double* acceleration) {
    for (const Scalar& l : motion.state(machine, t).actuators) *value++ = l.value, *rate++ = l.rate, *acceleration++ = l.acceleration;
  };
}

double slide_at(const Machine& crank, double theta) { return actuators_at(crank, SmallVector::Constant(1, theta))(0); }

// Where the slider turns back: the crank angle and the stroke at its dead centre next to home, by golden section.
struct DeadCentre {
  double theta, slide;
};
DeadCentre dead_centre(const Machine& crank) {
  const double home = crank.home()(0), sign = slide_at(crank, home + 1e-3) > slide_at(crank, home) ? 1 : -1;
  double a = home, b = home;
  while (sign * slide_at(crank, b + 0.01) > sign * slide_at(crank, b)) b += 0.01;
  b += 0.01;
  const double ratio = (std::sqrt(5.0) - 1) / 2;
  while (b - a > 1e-9) {
    const double left = b - ratio * (b - a), right = a + ratio * (b - a);
    (sign * slide_at(crank, left) > sign * slide_at(crank, right) ? b : a) =
        sign * slide_at(crank, left) > sign * slide_at(crank, right) ? right : left;
  }
  return {0.5 * (a + b), slide_at(crank, 0.5 * (a + b))};
}

}  // namespace

TEST_CASE("a hexapod whose limbs are driven follows with its exact rates and accelerations") {
  const Machine machine = test::make(test::hexapod());
  std::mt19937_64 random(11);
  for (int k = 0; k < 10; ++k) {
    test::Motion motion = test::random_motion(machine, random);
    motion.rate *= 0.3, motion.acceleration *= 0.2;
    std::vector<double> times;
    for (int i = 0; i <= 20; ++i) times.push_back(0.05 * i);
    const FollowedMotion followed = follow(machine, drive_of(machine, motion), times, motion.q);
    REQUIRE(followed.outcome == Outcome::good);
    REQUIRE(followed.reached == times.size());
    for (Eigen::Index i = 0; i <= 20; ++i) {
      const double t = times[static_cast<std::size_t>(i)];
      CAPTURE(k, t);
      // limbs to 1e-14 of the size, condition about 10
      CHECK((followed.value.row(i).transpose() - motion.at(t)).lpNorm<Eigen::Infinity>() < 1e-12);
      CHECK((followed.rate.row(i).transpose() - motion.rate_at(t)).lpNorm<Eigen::Infinity>() < 1e-11);
      CHECK((followed.acceleration.row(i).transpose() - motion.acceleration).lpNorm<Eigen::Infinity>() < 1e-10);
    }
  }
}

TEST_CASE("a way is followed in steps of its own: two samples far apart meet the same poses, and the way back leads home") {
  const Machine machine = test::make(test::hexapod());
  test::Motion motion{machine.home(), Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  motion.rate << 0.25, -0.2, 0.15, 1.0, -0.5, 0.4;
  const Drive drive = drive_of(machine, motion);
  const FollowedMotion followed = follow(machine, drive, {0, 1}, motion.q);
  REQUIRE(followed.reached == 2);
  CHECK((followed.value.row(1).transpose() - motion.at(1)).lpNorm<Eigen::Infinity>() < 1e-12);
  Follower back(machine, drive);
  const Follower::Arrival home = back.go(back.waymark(1, motion.at(1)), 0, 1e-10);
  CHECK(home.outcome == Outcome::good);
  CHECK((home.at.value - motion.q).lpNorm<Eigen::Infinity>() < 1e-12);
}

TEST_CASE("a slider driven past its dead centre meets a singular surface at its time") {
  const Machine machine = test::make(test::slider_crank());
  const double start = slide_at(machine, machine.home()(0));
  const DeadCentre dead = dead_centre(machine);
  const Drive drive = [&](double t, double* value, double* rate, double* acceleration) {  // reaches the dead centre at 2 s
    *value = start + (dead.slide - start) * t / 2;
    *rate = (dead.slide - start) / 2;
    *acceleration = 0;
  };
  std::vector<double> times;
  for (int i = 0; i <= 100; ++i) times.push_back(0.03 * i);
  const FollowedMotion followed = follow(machine, drive, times, machine.home());
  CHECK(followed.outcome == Outcome::singular);
  CHECK(followed.ending == Approx(2).margin(3e-9));  // 1e-9 of the span of 3 s
  REQUIRE(followed.reached == 67);                   // the last at 1.98 s
  CHECK(followed.value.topRows(67).allFinite());
  CHECK_FALSE(followed.value.bottomRows(34).array().isFinite().any());
  for (Eigen::Index i = 1; i < 67; ++i)  // always from the same side towards the dead centre
    CHECK(std::abs(followed.value(i, 0) - dead.theta) < std::abs(followed.value(i - 1, 0) - dead.theta));
}

TEST_CASE("what cannot be assembled is out of reach, and the mechanism's own reason is told") {
  // A rod of 0.35 m is too short for some turns of a crank of 0.4 m. The way starts a little before the edge, beyond the dead centre.
  const Machine machine(test::slider_crank(), {{0}, {0.4}, {0.35}});
  double edge = machine.home()(0);
  while (edge < 7 && std::isfinite(slide_at(machine, edge + 1e-5))) edge += 1e-5;
  REQUIRE(edge < 7);
  const double start = edge - 0.05, from = slide_at(machine, start), last = slide_at(machine, edge);
  const Drive drive = [&](double t, double* value, double* rate, double* acceleration) {
    *value = from + (last - from) * t, *rate = last - from, *acceleration = 0;
  };
  const FollowedMotion followed = follow(machine, drive, {0, 0.25, 0.5, 0.75, 2}, SmallVector::Constant(1, start));
  CHECK(followed.outcome == Outcome::unreachable);
  CHECK(followed.why == "the rod is too short");
  CHECK(followed.reached == 4);
  // The travel has a vertical tangent at the edge: a hundred-thousandth of a radian is more than a thousandth of it.
  CHECK(followed.ending == Approx(1).margin(0.01));
  CHECK(followed.value(3, 0) < edge);
}

TEST_CASE("given actuator values are approached from home in a straight line of actuators") {
  const Machine machine = test::make(test::hexapod());
  Eigen::VectorXd q(6);
  q << 0.1, -0.1, 0.7, 0.4, -0.2, 0.2;
  const Approach a = approach(machine, machine.home(), actuators_at(machine, q));
  CHECK(a.outcome == Outcome::good);
  CHECK(a.share == 1);
  CHECK((a.coordinates - q).lpNorm<Eigen::Infinity>() < 1e-12);

  const Machine crank = test::make(test::slider_crank());
  const DeadCentre dead = dead_centre(crank);
  const double start = slide_at(crank, crank.home()(0));
  const Approach beyond = approach(crank, crank.home(), SmallVector::Constant(1, start + 2 * (dead.slide - start)));
  CHECK(beyond.outcome == Outcome::singular);
  CHECK(beyond.share == Approx(0.5).margin(1e-9));
}
