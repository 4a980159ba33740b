#include <core/mechanics/model/generic_model.hpp>

#include <tests/mechanics/mechanisms.hpp>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;

namespace {

constexpr double rounding = 1e-12;  // forces of about 1, systems of up to 80 rows with condition numbers below 1e3

}  // namespace

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

TEST_CASE("the characteristic length is the mean distance of the platform's joints") {
  CHECK(characteristic_length(test::make_hexapod(test::BaseJoint::ball)) == Approx(0.25).epsilon(1e-14));
  CHECK(characteristic_length(test::make(test::four_bar())) == Approx(0.45 / 2).epsilon(1e-14));  // B at 0, C at the coupler's length
}
