// Inverse dynamics and joint reactions of the 4SPS-SPR against an independent model in 50-digit arithmetic (tests/data/4sps-spr.json),
// whose Newton and Euler equations hold to 1e-40.
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/four_sps_spr.hpp>
#include <tests/plugins/two_q_spr.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector, test::vector3;

namespace {

ParameterValues parameters_of(const json& c, const json& meta) {
  const std::string axis = c["input"]["dependent_axis"], name = c["name"];
  std::map<std::string, std::vector<double>> changes{{"dependent", {axis == "X" ? 0.0 : axis == "Y" ? 1.0 : 2.0}}};
  if (meta["other_parameters"].contains(name.substr(0, 3))) {
    const json& other = meta["other_parameters"][name.substr(0, 3)];
    const json& i = other["I_o"];
    changes["revolute_axis"] = {number(other["n6p"][0]), number(other["n6p"][1]), number(other["n6p"][2])};
    changes["platform_inertia"] = {number(i[0][0]), number(i[1][1]), number(i[2][2]), number(i[0][1]), number(i[0][2]), number(i[1][2])};
  }
  return test::values_with(test::four_sps_spr(), changes);
}

State state_of(const Machine& machine, const json& in) {
  const Vector3d angles(number(in["alpha"]), number(in["beta"]), number(in["gamma"]));  // Rz Ry Rx, as yaw, pitch and roll
  const test::AngleRates turning = test::angle_rates(angles, vector3(in["omega"]), vector3(in["epsilon"]));
  VectorXd q(5), rate(5), acceleration(5);
  q << vector(in["p_free"]), angles;
  rate << vector(in["v_free"]), turning.rates;
  acceleration << vector(in["a_free"]), turning.accelerations;
  State s;
  evaluate(machine, q.data(), rate.data(), acceleration.data(), s);
  return s;
}

}  // namespace

TEST_CASE("forces and reactions of the 4SPS-SPR's reference cases come out to nine digits") {
  const json file = test::reference("4sps-spr.json");
  const Vector3d gravity(0, 0, -number(file["meta"]["default_parameters"]["g"]));
  REQUIRE(file["cases"].size() == 6);
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["name"].get<std::string>()) {
      const json &in = c["input"], &out = c["output"];
      const Machine machine(test::four_sps_spr(), parameters_of(c, file["meta"]));
      const State s = state_of(machine, in);
      const test::Dynamics d(machine, s, {(Vector6d() << vector(in["F"]), vector(in["T"])).finished(), gravity});
      const VectorXd expected = vector(out["inverse_dynamics"]);
      d.check_actuators(expected.head(5));

      for (std::size_t i = 0; i < 5; ++i) {
        const std::string n = std::to_string(i + 1);
        check_equal("force of the base on a limb", d.force_on("cylinder " + n, "A" + n), vector(out["base_forces_on_legs"][i]));
      }
      CHECK(d.reactions.stresses.empty());
      const Vector3d n6 = vector(out["n6"]), moment = d.moment_on("platform", "B5"), force = d.force_on("platform", "B5");
      const Vector3d along = d.joint("B5").centre - d.joint("A5").centre, n5 = along.normalized();
      const double size = std::max(moment.norm(), d.length() * force.norm());
      check_equal("force of limb 5 on the platform", force, vector(out["R5_force_on_platform"]));
      check_equal("moment along n6 x n5", moment.dot(n6.cross(n5)), number(out["R5_moment_on_platform_along_n6xn5"]), size);
      check_equal("moment along n5", moment.dot(n5), number(out["R5_moment_on_platform_along_n5"]), size);
      check_equal("moment about the joint's own axis", moment.dot(n6), 0, size);

      // With limb masses the sixth number of the paper's formula is that moment by the limb's length, and not the ball's force along n6,
      // which limb 5's own inertia and weight change between A5 and B5.
      const double at_ball = d.force_on("cylinder 5", "A5").dot(n6);
      check_equal("sixth number of the formula", moment.dot(n6.cross(n5)) / along.norm(), expected(5), force.norm());
      check_equal("force of the ball along n6", at_ball, number(out["S5_base_force_dot_n6"]), force.norm());
      if (c["name"] == "A05_full") CHECK(std::abs(at_ball - expected(5)) > 1);
    }
}
