// The 2Q-SPR against an independent model in 50-digit arithmetic (tests/data/2q-spr.json).
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/two_q_spr_cases.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector, test::vector3;

namespace {

const BodyState& body_named(const Machine& machine, const State& s, const std::string& name) {
  const auto& bodies = machine.topology().bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].name == name) return s.bodies[i];
  throw std::out_of_range("no body is called " + name);
}

}  // namespace

TEST_CASE("every reference case of the 2Q-SPR comes out to nine digits") {
  const json file = test::reference("2q-spr.json");
  REQUIRE(file["cases"].size() == 8);
  for (const json& c : file["cases"]) {
    const std::string name = c["name"];
    DYNAMIC_SECTION(name) {
      const json &in = c["input"], &out = c["output"];
      const Machine machine(test::two_q_spr(), test::two_q_spr_cases::parameters_of(c, file["meta"]));
      const State s = test::two_q_spr_cases::state_of(machine, in);
      const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];
      const double size = platform.origin.norm(), speed = std::max(platform.velocity.norm(), platform.angular_velocity.norm());

      check_equal("position", platform.origin, vector(out["p"]));
      for (int r = 0; r < 3; ++r)
        check_equal("rotation", platform.rotation.row(r).transpose(), vector(in["rotation"][static_cast<std::size_t>(r)]), 1.0);
      CHECK(machine.topology().derived[0].name == "y");
      CHECK(machine.topology().derived[0].dependent);
      check_equal("dependent coordinate", s.derived[0].value, number(out["dependent"]), size);  // zero at home
      check_equal("velocity", platform.velocity, vector(out["v"]));
      check_equal("acceleration", platform.acceleration, vector(out["a"]));
      check_equal("angular velocity", platform.angular_velocity, vector(in["omega"]));
      check_equal("angular acceleration", platform.angular_acceleration, vector(in["epsilon"]));

      VectorXd lengths(5);
      for (int i = 0; i < 5; ++i) lengths(i) = s.actuators[static_cast<std::size_t>(i)].value;
      check_equal("lengths", lengths, vector(out["lengths"]));
      check_equal("rates", actuator_rates(s).head(5), vector(out["rates"]));
      check_equal("accelerations", actuator_accelerations(s).head(5), vector(out["accels"]));

      const auto joint = [&](const std::string& n) -> const JointState& {
        return s.joints[static_cast<std::size_t>(test::joint_named(machine, n))];
      };
      check_equal("f3", joint("R3").axis[0], vector(out["f3"]));
      check_equal("d3", joint("S3").centre - platform.origin, vector(out["d3"]));
      for (std::size_t i = 0; i < 2; ++i) {
        const std::string n = std::to_string(i + 1);
        check_equal("n", joint("R" + n + "1").axis[0], vector(file["meta"]["n"][i]));
        check_equal("N", joint("RB" + n + "1").axis[0], vector(out["N"][i]), 1.0);
        check_equal("mu", joint("R" + n + "5").axis[0], vector(out["mu"][i]));
        const BodyState &lower = body_named(machine, s, "lower beam G" + n), &upper = body_named(machine, s, "upper beam g" + n);
        check_equal("omega_G", lower.angular_velocity, number(out["omega_G"][i]) * vector3(file["meta"]["n"][i]), speed);
        check_equal("omega_g", upper.angular_velocity, vector(out["omega_g"][i]));
        check_equal("eps_g", upper.angular_acceleration, vector(out["eps_g"][i]));
      }

      const ClosedForm g = closed_form(machine, s, characteristic_length(machine));
      for (int i = 0; i < 6; ++i) {
        const VectorXd row = vector(out["J"][static_cast<std::size_t>(i)]);
        check_equal("J, force", g.jacobian.row(i).head(3).transpose(), row.head(3));
        check_equal("J, moment", g.jacobian.row(i).tail(3).transpose(), row.tail(3));
      }
      check_equal("det J", g.determinant, number(out["detJ"]));
      check_equal("J' V", g.jacobian_rate * platform.twist(), vector(out["bias"]));
      check_equal("massless statics", closed_statics(g, test::two_q_spr_cases::load_of(in)), vector(out["statics_massless"]));
    }
  }
}

TEST_CASE("joint angles of the 2Q-SPR's reference cases come out to nine digits") {
  const json file = test::reference("2q-spr.json");
  const json& home = file["cases"][0]["output"]["angles"];
  for (const json& c : file["cases"]) {
    const Machine machine(test::two_q_spr(), test::two_q_spr_cases::parameters_of(c, file["meta"]));
    const State s = test::two_q_spr_cases::state_of(machine, c["input"]);
    const Closure closure(machine);
    int compared = 0;
    for (const auto& [key, angle] : c["output"]["angles"].items()) {
      CAPTURE(c["name"], key);
      const std::string joint = key == "S3_cone_deg" ? "S3" : key.substr(0, key.size() - 4);
      // A motion is counted from home; the angles of the reference are those between lines.
      const double motion = closure.motion(s.bodies, test::joint_named(machine, joint)).at(0);
      CHECK(std::abs(motion - (number(angle) - number(home[key])) * deg) < test::tolerance);
      ++compared;
    }
    CHECK(compared == 16);
  }
}

TEST_CASE("at rest the rods of the 2Q-SPR carry load and weights as the reference cases say") {
  const json file = test::reference("2q-spr.json");
  const Vector3d gravity = test::two_q_spr_cases::gravity_of(file);
  int cases = 0;
  for (const json& c : file["cases"]) {
    const json& in = c["input"];
    if (!vector(in["omega"]).isZero() || !vector(in["epsilon"]).isZero()) continue;
    CAPTURE(c["name"]);
    ++cases;
    const Machine machine(test::two_q_spr(), test::two_q_spr_cases::parameters_of(c, file["meta"]));
    const State s = test::two_q_spr_cases::state_of(machine, in);
    const VectorXd forces =
        closed_statics(closed_form(machine, s, characteristic_length(machine)), test::two_q_spr_cases::load_of(in)).head(5) +
        weight_forces(machine, s, gravity);
    const VectorXd expected = vector(c["output"]["inverse_dynamics"]).head(5);
    check_equal("by virtual work", forces, expected);

    VectorXd wrenches = weights(machine, s, gravity);
    wrenches.segment<6>(6 * machine.topology().platform - 6) += test::two_q_spr_cases::load_of(in);
    check_equal("by the equilibrium of every body", generic_statics(generic_model(machine, s), wrenches).actuator_forces, expected);
  }
  CHECK(cases == 3);
}
