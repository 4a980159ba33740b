#include <core/mechanics/model/generic_model.hpp>

#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr double rounding = 1e-12;  // forces of about 1, systems of up to 80 rows with condition numbers below 1e3

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

TEST_CASE("the bias is the change of the constraint rows times the twists") {
  // PHI' V by differences of PHI itself along the motion. Fourth order with h = 1e-3 s at rates of about one a second: 1e-12 from the
  // order, 1e-13 from rounding, times twists below 10.
  constexpr double h = 1e-3, tolerance = 1e-8;
  const Machine balls = test::make_hexapod(test::BaseJoint::ball), crosses = test::make_hexapod(test::BaseJoint::universal),
                four_bar = test::make(test::four_bar()), arm = test::make(test::arm()), crank = test::make(test::slider_crank());
  std::mt19937_64 random(21);
  for (const Machine* machine : {&balls, &crosses, &four_bar, &arm, &crank}) {
    double largest = 0;
    for (int k = 0; k < 20; ++k) {
      const test::Motion motion = test::random_motion(*machine, random);
      INFO(machine->info().name << ", q = " << motion.q.transpose());
      const State s = motion.state(*machine);
      const auto rows = [&](double t) { return generic_model(*machine, motion.state(*machine, t)).constraints; };
      const Eigen::VectorXd expected = (8.0 * (rows(h) - rows(-h)) - (rows(2 * h) - rows(-2 * h))) / (12 * h) * stacked_twists(s);
      const GenericModel model = generic_model(*machine, s);
      largest = std::max(largest, expected.lpNorm<Eigen::Infinity>());
      CHECK((model.bias - expected).lpNorm<Eigen::Infinity>() < tolerance);
      CHECK((model.constraints * stacked_twists(s)).lpNorm<Eigen::Infinity>() < rounding);
    }
    CHECK(largest > 0.01);  // motions that show no bias would prove nothing
  }
}

TEST_CASE("actuation rows measure the motion at their joints, linear and angular") {
  const Machine machine = test::make(test::arm());
  const double q[] = {0.4, 0.3, 0.5}, rate[] = {0.7, -0.2, 1.1}, none[] = {0, 0, 0};
  State s;
  evaluate(machine, q, rate, none, s);
  const Eigen::VectorXd measured = generic_model(machine, s).actuation * stacked_twists(s);
  for (int i = 0; i < 3; ++i) CHECK(measured(i) == Approx(rate[i]).epsilon(1e-14));
}

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

TEST_CASE("the characteristic length is the mean distance of the platform's joints") {
  CHECK(characteristic_length(test::make_hexapod(test::BaseJoint::ball)) == Approx(0.25).epsilon(1e-14));
  CHECK(characteristic_length(test::make(test::four_bar())) == Approx(0.45 / 2).epsilon(1e-14));  // B at 0, C at the coupler's length
}
