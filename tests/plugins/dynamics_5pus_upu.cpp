// Inverse dynamics and joint reactions of the 5PUS-UPU against an independent model (tests/data/5pus-upu.json).
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/five_pus_upu.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

TEST_CASE("forces and reactions of the 5PUS-UPU's reference cases come out to nine digits") {
  const json file = test::reference("5pus-upu.json");
  REQUIRE(file["cases"].size() == 13);
  const Vector3d gravity = vector(file["parameters"]["g"]);
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["name"].get<std::string>() << ", " << c["model"].get<std::string>()) {
      test::Changes changes = test::model(c["model"]);
      if (c.contains("o6_override")) changes["h6"] = {number(c["o6_override"][2])};
      const Machine machine(test::five_pus_upu(), test::values_with(test::five_pus_upu(), changes));
      const State s = test::state_at(machine, vector(c["pose_x_y_z_alpha_beta"]), vector(c["rates"]), vector(c["accels"]));
      const test::Dynamics d(machine, s, {vector(c["wrench"]), gravity});
      const json& expected = c["inverse_dynamics"];
      d.check_actuators(vector(expected["slider_force"]));
      CHECK(d.reactions.stresses.empty());

      const VectorXd balls = vector(expected["S_reaction_on_platform"]);
      for (int i = 0; i < 5; ++i)
        check_equal("force of a ball", d.force_on("platform", "S" + std::to_string(i + 1)), balls.segment<3>(3 * i));

      // Of the whole constraint limb, its weight and inertia included, about the platform's reference point. Small against the balls'
      // forces, which it is the remainder of.
      const Vector6d limb = d.limbs()[5];
      const VectorXd wrench = vector(expected["constraint_limb_wrench_on_platform"]);
      const double size = balls.lpNorm<Eigen::Infinity>();
      check_equal("force of the constraint limb", limb.head<3>(), wrench.head<3>(), size);
      check_equal("couple of the constraint limb", limb.tail<3>(), wrench.tail<3>(), size * d.length());
    }
}

TEST_CASE("a massless constraint limb of the 5PUS-UPU transmits its constraint wrench and nothing else") {
  const json file = test::reference("5pus-upu.json");
  for (const json& c : file["cases"]) {
    if (!c.contains("static_massless")) continue;  // of the case with U6 above the platform
    CAPTURE(c["name"], c["model"]);
    const Machine machine(test::five_pus_upu(), test::values_with(test::five_pus_upu(), test::model(c["model"])));
    const State s = test::state_at(machine, vector(c["pose_x_y_z_alpha_beta"]));
    const test::Dynamics d(machine, s, {vector(c["wrench"]), Vector3d::Zero()});  // at rest, without weights
    const json& expected = c["static_massless"];
    if (vector(c["wrench"]).isZero()) continue;
    d.check_actuators(vector(expected["slider_force"]));
    const VectorXd wrench = vector(expected["constraint_limb_wrench_on_platform"]), tension = vector(expected["limb_axial_tension"]);
    const double size = tension.lpNorm<Eigen::Infinity>();
    check_equal("force of the constraint limb", d.limbs()[5].head<3>(), wrench.head<3>(), size);
    check_equal("couple of the constraint limb", d.limbs()[5].tail<3>(), wrench.tail<3>(), size * d.length());
    for (int i = 0; i < 5; ++i) {  // a rod with two forces: along itself, tension pulls the ball towards the slider
      const std::string n = std::to_string(i + 1);
      const Vector3d up = (d.joint("U" + n).centre - d.joint("S" + n).centre).normalized();
      check_equal("force of a rod", d.force_on("platform", "S" + n), tension(i) * up, size);
    }
  }
}
