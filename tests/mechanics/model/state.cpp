// The state of bodies in motion, held against what the plain placement says a moment before and after.
#include <core/mechanics/model/state.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr double h = 1e-3;  // [s]; rates are about one a second, so differences of fourth order are exact to about h^4 = 1e-12
constexpr double rate_tolerance = 1e-9, acceleration_tolerance = 1e-7;  // plus rounding: 1e-16 / h and 1e-16 / h^2

template <class F>
auto rate_of(F&& f) {
  return ((8.0 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)).eval();
}

const pm_mechanism* machines[] = {&test::hexapod(), &test::four_bar(), &test::arm(), &test::slider_crank()};

}  // namespace

TEST_CASE("a rigid body's angular velocity is the rate of its rotation") {
  std::mt19937_64 random(11);
  for (const pm_mechanism* table : machines) {
    const Machine machine = test::make(*table);
    for (int k = 0; k < 20; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      const State s = motion.state(machine);
      for (std::size_t i = 1; i < s.bodies.size(); ++i) {
        if (machine.topology().bodies[i].slender) continue;
        INFO(table->name << ", body " << machine.topology().bodies[i].name << ", q = " << motion.q.transpose());
        // Small rotation from now to t, as an axis times angle: its rate at t = 0 is the angular velocity.
        const Vector3d w = rate_of([&](double t) -> Vector3d {
          const Eigen::AngleAxisd turn(motion.state(machine, t).bodies[i].rotation * s.bodies[i].rotation.transpose());
          return turn.axis() * turn.angle();
        });
        CHECK((w - s.bodies[i].angular_velocity).norm() < rate_tolerance);
      }
    }
  }
}

TEST_CASE("a slender body turns with its axis and does not spin") {
  const Machine machine = test::make(test::hexapod());
  const int leg = test::body_named(machine, "cylinder 2");
  const auto i = static_cast<std::size_t>(leg);
  std::mt19937_64 random(12);
  for (int k = 0; k < 20; ++k) {
    const test::Motion motion = test::random_motion(machine, random);
    CAPTURE(motion.q.transpose());
    const State s = motion.state(machine);
    const auto axis = [&](double t) -> Vector3d { return motion.state(machine, t).bodies[i].rotation.col(2); };
    CHECK((s.bodies[i].angular_velocity.cross(axis(0)) - rate_of(axis)).norm() < rate_tolerance);
    CHECK(std::abs(s.bodies[i].angular_velocity.dot(axis(0))) < 1e-14);
    CHECK((s.bodies[i].rotation.transpose() * s.bodies[i].rotation - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(s.bodies[i].rotation.determinant() > 0);
  }
}

TEST_CASE("velocities are rates of places, and accelerations rates of velocities, for every body") {
  std::mt19937_64 random(13);
  for (const pm_mechanism* table : machines) {
    const Machine machine = test::make(*table);
    for (int k = 0; k < 20; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      const State s = motion.state(machine);
      for (std::size_t i = 1; i < s.bodies.size(); ++i) {
        INFO(table->name << ", body " << machine.topology().bodies[i].name << ", q = " << motion.q.transpose());
        const auto body = [&](double t) { return motion.state(machine, t).bodies[i]; };
        CHECK((rate_of([&](double t) { return body(t).origin; }) - s.bodies[i].velocity).norm() < rate_tolerance);
        CHECK((rate_of([&](double t) { return body(t).twist(); }) - s.bodies[i].twist_rate()).norm() < acceleration_tolerance);
      }
      for (std::size_t i = 0; i < s.actuators.size(); ++i) {
        const auto vector = [&](double t) {
          const Scalar x = motion.state(machine, t).actuators[i];
          return Eigen::Vector2d(x.value, x.rate);
        };
        const Eigen::Vector2d rates = rate_of(vector);
        CHECK(std::abs(rates(0) - s.actuators[i].rate) < rate_tolerance);
        CHECK(std::abs(rates(1) - s.actuators[i].acceleration) < acceleration_tolerance);
      }
    }
  }
}

TEST_CASE("a sleeve on a turning boom has the textbook's centripetal and Coriolis acceleration") {
  const Machine machine = test::make(test::arm());
  const double theta = 0.3, w = 2.0, d = 0.4, v = 0.7;
  const double q[] = {theta, d, 0}, rate[] = {w, v, 0}, acceleration[] = {0, 0, 0};
  State s;
  evaluate(machine, q, rate, acceleration, s);
  const Vector3d radial(std::cos(theta), std::sin(theta), 0), across(-std::sin(theta), std::cos(theta), 0);
  const BodyState& sleeve = s.bodies[2];
  CHECK((sleeve.acceleration - (-d * w * w * radial + 2 * v * w * across)).norm() < 1e-14);
  CHECK((sleeve.angular_velocity - Vector3d(0, 0, w)).norm() < 1e-15);
}

TEST_CASE("an unreachable pose says so and why: a plugin's NaN is a pose without numbers") {
  const double out_of_reach[] = {-1.5}, slow[] = {1.0}, none[] = {0.0};
  const Machine short_rod(test::slider_crank(), {{0}, {0.4}, {0.35}});
  State s;
  evaluate(short_rod, out_of_reach, slow, none, s);
  CHECK(s.status == PM_UNREACHABLE);
  CHECK(s.why == "the rod is too short");

  const Machine broken(test::slider_crank(), {{13}, {0.2}, {0.5}});  // the fault "nan", beyond 0.9 rad
  const double beyond[] = {1.0}, before[] = {0.7};
  evaluate(broken, beyond, slow, none, s);
  CHECK(s.status == PM_SINGULAR);
  CHECK(s.why == "the geometry has no finite numbers there");
  evaluate(broken, before, slow, none, s);
  CHECK(s.status == PM_OK);
  CHECK(s.why.empty());
}
