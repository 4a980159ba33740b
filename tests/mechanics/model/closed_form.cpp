#include <core/mechanics/model/closed_form.hpp>

#include <core/mechanics/model/generic_model.hpp>
#include <tests/mechanics/mechanisms.hpp>

#include <catch2/catch.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;

namespace {
const pm_mechanism* all[] = {&test::hexapod(), &test::four_bar(), &test::arm(), &test::slider_crank()};
constexpr double form_rounding = 1e-11;  // condition numbers up to about 100
}  // namespace

TEST_CASE("the Jacobian's rate is its change along the motion") {
  constexpr double h = 1e-3, tolerance = 1e-8;  // differences of fourth order; entries change by about one a second
  std::mt19937_64 random(31);
  for (const pm_mechanism* table : all) {
    const Machine machine = test::make(*table);
    const double length = characteristic_length(machine);
    for (int k = 0; k < 20; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      INFO(table->name << ", q = " << motion.q.transpose());
      const auto g = [&](double t) { return closed_form(machine, motion.state(machine, t), length).jacobian; };
      const Matrix6d expected = (8.0 * (g(h) - g(-h)) - (g(2 * h) - g(-2 * h))) / (12 * h);
      REQUIRE(expected.cwiseAbs().maxCoeff() > 1e-4);
      CHECK((closed_form(machine, motion.state(machine), length).jacobian_rate - expected).cwiseAbs().maxCoeff() < tolerance);
    }
  }
}

TEST_CASE("forward velocity and acceleration undo the inverse") {
  std::mt19937_64 random(32);
  for (const pm_mechanism* table : all) {
    const Machine machine = test::make(*table);
    for (int k = 0; k < 20; ++k) {
      const test::Motion motion = test::random_motion(machine, random);
      INFO(table->name << ", q = " << motion.q.transpose());
      const State s = motion.state(machine);
      const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];
      const ClosedForm c = closed_form(machine, s, characteristic_length(machine));
      CHECK((forward_velocity(c, actuator_rates(s)) - platform.twist()).norm() < form_rounding * (1 + platform.twist().norm()));
      CHECK((forward_acceleration(c, actuator_accelerations(s), platform.twist()) - platform.twist_rate()).norm() <
            form_rounding * (1 + platform.twist_rate().norm()));
    }
  }
}

TEST_CASE("the condition number does not depend on the unit of length, and is infinite when G is singular") {
  // The arm at d: rows theta = w_z, d, phi, and v_z, w_y are unit vectors; force_y reads v_y - d w_z. With moments in the characteristic
  // length L the pair (w_z, v_y - d w_z) has the matrix [1 0; -d/L 1], whose condition number is known in closed form.
  const Machine machine = test::make(test::arm());
  const double d = 0.3, length = 0.2;
  const double q[] = {0.1, d, 0.2}, none[] = {0, 0, 0};
  State s;
  evaluate(machine, q, none, none, s);
  const double k = d / length, sigma = std::sqrt(1 + 0.5 * k * k + 0.5 * k * std::sqrt(k * k + 4));
  CHECK(closed_form(machine, s, length).condition == Approx(sigma * sigma).epsilon(1e-12));

  const Machine crank = test::make(test::slider_crank());
  State regular;
  const double home[] = {0.8}, still[] = {0};
  evaluate(crank, home, still, still, regular);
  const ClosedForm c = closed_form(crank, regular, 0.2);
  CHECK(c.determinant == Approx(c.jacobian.determinant()));
  CHECK(std::isfinite(c.condition));
}
