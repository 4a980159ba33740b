// Inverse dynamics and joint reactions of the 4SPS-SPR against an independent model in 50-digit arithmetic (tests/data/4sps-spr.json),
// whose Newton and Euler equations hold to 1e-40.
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/four_sps_spr_cases.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

TEST_CASE("forces and reactions of the 4SPS-SPR's reference cases come out to nine digits") {
  const json file = test::reference("4sps-spr.json");
  REQUIRE(file["cases"].size() == 6);
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["name"].get<std::string>()) {
      const json &in = c["input"], &out = c["output"];
      const Machine machine(test::four_sps_spr(), test::four_sps_spr_cases::parameters_of(c, file["meta"]));
      const State s = test::four_sps_spr_cases::state_of(machine, in);
      const test::Dynamics d(machine, s, {test::four_sps_spr_cases::load_of(in), test::four_sps_spr_cases::gravity_of(file)});
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
