#include <core/assertion.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr double rounding = 1e-12;  // forces of about 1, systems of up to 80 rows with condition numbers below 1e3

constexpr double closed_rounding = 1e-11;  // condition numbers up to about 100

const pm_mechanism* all[] = {&test::hexapod(), &test::four_bar(), &test::arm(), &test::slider_crank()};

State at_home(const Machine& machine) {
  const Eigen::VectorXd q = machine.home(), zero = Eigen::VectorXd::Zero(machine.dof());
  State s;
  evaluate(machine, q.data(), zero.data(), zero.data(), s);
  return s;
}

// The constraint force of a joint whose first three rows are forces along x y z, on its body b.
Vector3d joint_force(const GenericModel& model, const GenericStatics& statics, int joint) {
  const auto first = std::find(model.joint_of_row.begin(), model.joint_of_row.end(), joint) - model.joint_of_row.begin();
  return statics.reactions.segment<3>(first);
}

Vector6d load_of(const Vector3d& force, const Vector3d& moment) { return (Vector6d() << force, moment).finished(); }

// One body on six rows, those of `constraints` and one actuator that turns it about z.
GenericModel one_body(const Eigen::MatrixXd& constraints) {
  GenericModel m;
  m.constraints = constraints;
  m.actuation = Eigen::MatrixXd::Zero(1, 6);
  m.actuation(0, 5) = 1;
  return m;
}

}  // namespace

TEST_CASE("a weight in the middle is carried by six limbs alike") {
  const double weight = 600;
  const Vector6d load = load_of({0, 0, -weight}, Vector3d::Zero());
  for (const test::BaseJoint base : {test::BaseJoint::ball, test::BaseJoint::universal}) {
    const Machine machine = test::make_hexapod(base);
    const State s = at_home(machine);
    const GenericModel model = generic_model(machine, s);
    const GenericStatics statics = generic_statics(machine, model, load);
    CHECK(statics.residual < rounding);
    for (int i = 0; i < 6; ++i) {
      const std::string limb = std::to_string(i + 1);
      CAPTURE(limb);
      const int a = test::joint_named(machine, "A" + limb), b = test::joint_named(machine, "B" + limb);
      const Vector3d n = (s.joints[static_cast<std::size_t>(b)].centre - s.joints[static_cast<std::size_t>(a)].centre).normalized();
      const double push = weight / 6 / n.z();
      CHECK(statics.actuator_forces(i) == Approx(push).epsilon(rounding));
      // The base pushes the limb, and the limb the platform, along the limb.
      CHECK((joint_force(model, statics, a) - push * n).norm() < rounding * weight);
      CHECK((joint_force(model, statics, b) - push * n).norm() < rounding * weight);
    }
  }
}

TEST_CASE("a four-bar's crank torque follows from the rocker, a member with two forces") {
  const Machine machine = test::make(test::four_bar());
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> force(-50, 50);
  for (int k = 0; k < 20; ++k) {
    const test::Motion motion = test::random_motion(machine, random);
    CAPTURE(motion.q.transpose());
    const State s = motion.state(machine);
    const Vector3d a = s.joints[0].centre, b = s.joints[1].centre, c = s.joints[2].centre, d = s.joints[3].centre;
    const Vector3d f(force(random), force(random), 0);  // on the coupler at B
    const Vector3d m(0, 0, 0.1 * force(random));
    // Moments of the coupler about B: m + BC x R e = 0. The crank then feels f + R e at B.
    const Vector3d e = (c - d).normalized();
    const double rocker = -m.z() / (c - b).cross(e).z();
    const double torque = -(b - a).cross(f + rocker * e).z();
    const GenericStatics statics = generic_statics(machine, generic_model(machine, s), load_of(f, m));
    CHECK(statics.residual < rounding);
    CHECK(statics.actuator_forces(0) == Approx(torque).margin(1e-10));
  }
}

TEST_CASE("a couple along a cylindrical joint loads its roll, a force its slide, and the lever its base") {
  const Machine machine = test::make(test::arm());
  const double theta = 0.3, d = 0.35;
  const double q[] = {theta, d, 0.6}, none[] = {0, 0, 0};
  State s;
  evaluate(machine, q, none, none, s);
  const Vector3d x(std::cos(theta), std::sin(theta), 0), y(-std::sin(theta), std::cos(theta), 0);
  const GenericStatics statics = generic_statics(machine, generic_model(machine, s), load_of(5 * x + 7 * y, 2 * x));
  CHECK(statics.actuator_forces(0) == Approx(-7 * d).epsilon(rounding));
  CHECK(statics.actuator_forces(1) == Approx(-5).epsilon(rounding));
  CHECK(statics.actuator_forces(2) == Approx(-2).epsilon(rounding));
}

TEST_CASE("a load that nothing can carry leaves a residual") {
  // At dead centre, rod across the slider's axis seen from the crank, no slider force turns the crank. Here the crank's lever vanishes:
  // rod in the plane of crank pin and crank axis.
  const Machine machine = test::make(test::slider_crank());
  double low = 2.0, high = 4.5;  // the lever of the rod changes its sign between
  const auto lever = [&](double theta) {
    State s;
    const double none[] = {0};
    evaluate(machine, &theta, none, none, s);
    REQUIRE(s.status == PM_OK);
    return s.joints[1].centre.cross(s.bodies[2].rotation.col(2)).z();
  };
  REQUIRE(lever(low) * lever(high) < 0);
  for (int i = 0; i < 60; ++i) (lever(low) * lever(0.5 * (low + high)) > 0 ? low : high) = 0.5 * (low + high);
  const double none[] = {0};
  State s;
  evaluate(machine, &low, none, none, s);
  const GenericStatics statics = generic_statics(machine, generic_model(machine, s), load_of(Vector3d::Zero(), {0, 0, 1}));
  CHECK(statics.residual > 0.1);
}

TEST_CASE("actuator forces do the work of the load, with its sign turned") {
  std::mt19937_64 random(33);
  for (const pm_mechanism* table : all) {
    const Machine machine = test::make(*table);
    const test::Motion motion = test::random_motion(machine, random);
    INFO(table->name << ", q = " << motion.q.transpose());
    const State s = motion.state(machine);
    const Vector6d load = (Vector6d() << 3, -5, 7, 0.2, 0.4, -0.6).finished();
    const Vector6d forces = closed_statics(closed_form(machine, s, 1.0), load);
    double power = load.dot(s.bodies[static_cast<std::size_t>(machine.topology().platform)].twist());
    for (std::size_t i = 0; i < s.actuators.size(); ++i) power += forces(static_cast<int>(i)) * s.actuators[i].rate;
    CHECK(std::abs(power) < closed_rounding * load.norm());
  }
}

TEST_CASE("a weight on six limbs pushes them: positive forces extend") {
  const Machine machine = test::make_hexapod(test::BaseJoint::ball);
  const Eigen::VectorXd q = machine.home(), zero = Eigen::VectorXd::Zero(6);
  State s;
  evaluate(machine, q.data(), zero.data(), zero.data(), s);
  const Vector6d forces = closed_statics(closed_form(machine, s, 1.0), (Vector6d() << 0, 0, -600, 0, 0, 0).finished());
  for (int i = 0; i < 6; ++i) CHECK(forces(i) == Approx(100 / s.bodies[2].rotation(2, 2)).epsilon(closed_rounding));
}

TEST_CASE("the closed form and the generic model ask the actuators for the same forces") {
  std::mt19937_64 random(34);
  std::uniform_real_distribution<double> any(-1, 1);
  for (const pm_mechanism* table : all) {
    const Machine machine = test::make(*table);
    const double length = characteristic_length(machine);
    for (int k = 0; k < 10; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      INFO(table->name << ", q = " << motion.q.transpose());
      const State s = motion.state(machine);
      const ClosedForm c = closed_form(machine, s, length);
      if (!(c.condition < 100)) continue;
      const Vector6d load = load_of({any(random), any(random), any(random)}, length * Vector3d(any(random), any(random), any(random)));
      const Vector6d closed = closed_statics(c, load);
      const GenericStatics generic = generic_statics(machine, generic_model(machine, s), load);
      CHECK(generic.residual < rounding);
      CHECK((generic.actuator_forces - closed.head(machine.dof())).norm() < 100 * rounding * (1 + closed.norm()));
    }
  }
}

TEST_CASE("two rows that hold the same way share a force so that the sum of squares is least") {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(6, 6);
  rows(0, 0) = 1, rows(1, 0) = 2;  // lambda1 + 2 lambda2 = 5: nearest to zero at (1, 2)
  rows(2, 1) = rows(3, 2) = rows(4, 3) = rows(5, 4) = 1;
  const GenericStatics s = generic_statics(one_body(rows), load_of({-5, -7, 0}, {0, 0, -3}));
  CHECK(s.residual < rounding);
  CHECK(s.reactions(0) == Approx(1).epsilon(rounding));
  CHECK(s.reactions(1) == Approx(2).epsilon(rounding));
  CHECK(s.reactions(2) == Approx(7).epsilon(rounding));
  CHECK(s.actuator_forces(0) == Approx(3).epsilon(rounding));
}

TEST_CASE("a weight pulls at the centre of mass, however the body is turned") {
  const Machine machine = test::make(test::arm());
  const test::Motion motion{Vector3d(0.3, 0.4, 0.5), Vector3d::Zero(), Vector3d::Zero()};
  const State s = motion.state(machine);
  const Vector3d gravity(1, -2, -9);
  const Eigen::VectorXd w = weights(machine, s, gravity);
  REQUIRE(w.size() == 6 * (static_cast<int>(s.bodies.size()) - 1));
  for (std::size_t b = 1; b < s.bodies.size(); ++b) {
    // The power of the weight on any twist is that of m g on the velocity of the centre of mass.
    const Inertia& inertia = machine.topology().bodies[b].inertia;
    const Vector3d v(0.1, 0.2, -0.3), turn(-0.4, 0.6, 0.5), c = s.bodies[b].rotation * inertia.centre;
    const double power = inertia.mass * gravity.dot(v + turn.cross(c));
    CHECK(w.segment<6>(6 * static_cast<int>(b) - 6).dot(load_of(v, turn)) == Approx(power).margin(1e-14));
  }
}

TEST_CASE("statics of a state that was never assembled is refused") {
  const Machine machine = test::make(test::arm());
  const State never;
  CHECK_THROWS_AS(weights(machine, never, Vector3d::UnitZ()), AssertionFailed);
  CHECK_THROWS_AS(generic_model(machine, never), AssertionFailed);
  CHECK_THROWS_AS(closed_form(machine, never, 1.0), AssertionFailed);
  const GenericModel model = generic_model(machine, at_home(machine));
  CHECK_THROWS_AS(generic_statics(model, Eigen::VectorXd::Zero(model.constraints.cols() + 1)), AssertionFailed);
}
