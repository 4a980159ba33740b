// The motion of Table 1 of Zhang et al. 2016, prescribed at the rods of the 2Q-SPR: r = r0 + c t^3 / 6.
#include <core/mechanics/displacement/displacement.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/numbers.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/two_q_spr.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector, test::matrix;

namespace {

constexpr int steps_per_second = 100;

const VectorXd jerk = (VectorXd(5) << 2.5e-3, 2.8e-3, 3.3e-3, 3.6e-3, 0.8e-3).finished();  // [m/s^3]

std::vector<ForwardSolution> table1(const Machine& machine, double until) {
  const VectorXd home = Eigen::Map<const VectorXd>(machine.home_pose().numbers.data() + machine.layout().actuator(0), 5);
  std::vector<VectorXd> actuators;
  for (int k = 0; k <= std::lround(until * steps_per_second); ++k)
    actuators.push_back(home + jerk * std::pow(double(k) / steps_per_second, 3) / 6);
  return follow_actuators(machine, actuators, machine.home());
}

}  // namespace

TEST_CASE("the 2Q-SPR follows the rods of Table 1 to nine digits") {
  const json samples = test::reference("2q-spr.json")["table1_trajectory"];
  REQUIRE(samples.size() == 5);
  const Machine machine(test::two_q_spr(), test::values_with(test::two_q_spr(), {}));
  const std::vector<ForwardSolution> way = table1(machine, 3);
  const Vector6d load = (Vector6d() << 0, 0, 1000, 0, 0, 10).finished();
  for (const json& c : samples) {
    const double t = number(c["t"]);
    CAPTURE(t);
    const auto k = static_cast<std::size_t>(std::lround(t * steps_per_second));
    REQUIRE(k < way.size());
    REQUIRE(way[k].outcome == Outcome::good);
    const VectorXd q = way[k].coordinates;

    // The platform's motion follows from the rods', by G and by its rate along the motion.
    VectorXd still = VectorXd::Zero(5);
    State s;
    evaluate(machine, q.data(), still.data(), still.data(), s);
    REQUIRE(s.status == PM_OK);
    const double length = characteristic_length(machine);
    const auto platform = [&]() -> const BodyState& { return s.bodies[static_cast<std::size_t>(machine.topology().platform)]; };
    Vector6d rates = Vector6d::Zero(), accelerations = Vector6d::Zero();
    rates.head(5) = jerk * t * t / 2;
    accelerations.head(5) = jerk * t;
    const Vector6d twist = forward_velocity(closed_form(machine, s, length), rates);
    s = test::state_at(machine, q.head(2), platform().rotation, {twist(0), twist(2)}, twist.tail(3), {0, 0}, Vector3d::Zero());
    const ClosedForm g = closed_form(machine, s, length);

    check_equal("position", platform().origin, vector(c["p"]));
    for (int r = 0; r < 3; ++r)
      check_equal("rotation", platform().rotation.row(r).transpose(), vector(c["R"][static_cast<std::size_t>(r)]), 1.0);
    check_equal("twist", platform().twist(), vector(c["V"]));
    check_equal("twist rate", forward_acceleration(g, accelerations, twist), vector(c["A"]));
    check_equal("det G", g.determinant, number(c["det"]));
    check_equal("statics", closed_statics(g, load), vector(c["statics"]));
  }
}

TEST_CASE("the ZYZ angles are readings, and at home only the tilt has a value") {
  const Machine machine(test::two_q_spr(), test::values_with(test::two_q_spr(), {}));
  const auto readings = [&](const VectorXd& q) {
    const std::span<const double> at{q.data(), static_cast<std::size_t>(q.size())};
    return machine.readings(at, machine.pose(at));
  };
  const std::vector<double> home = readings(machine.home());
  CHECK(std::isnan(home.at(0)));
  CHECK(home.at(1) == 0);
  CHECK(std::isnan(home.at(2)));
  for (const json& c : test::reference("2q-spr.json")["table1_trajectory"]) {
    const double t = number(c["t"]);
    if (t == 0) continue;
    CAPTURE(t);
    VectorXd q(5);
    q << number(c["p"][0]), number(c["p"][2]), test::yaw_pitch_roll(matrix(c["R"]));
    const std::vector<double> zyz = readings(q);
    check_equal("alpha, beta, gamma", Vector3d(zyz.data()) / deg, vector(c["zyz_deg"]));
  }
}

TEST_CASE("the motion of Table 1 ends at a singular surface between 3.25 and 3.5 s") {
  const Machine machine(test::two_q_spr(), test::values_with(test::two_q_spr(), {}));
  const std::vector<ForwardSolution> way = table1(machine, 3.5);
  const double reached = (double(way.size()) - 1) / steps_per_second;
  CHECK(way.back().outcome != Outcome::good);
  CHECK(reached > 3.25);
  CHECK(reached < 3.5);
  const VectorXd last = way.at(way.size() - 2).coordinates, still = VectorXd::Zero(5);
  State s;
  evaluate(machine, last.data(), still.data(), still.data(), s);
  // det G falls from 5.7e-5 at home like the root of the time that is left: a hundredth of a second before the end it is small.
  CHECK(closed_form(machine, s, characteristic_length(machine)).determinant < 1e-5);
  CHECK(closed_form(machine, s, characteristic_length(machine)).determinant > 0);
}
