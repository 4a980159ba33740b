// The 4SPS-SPR against an independent model in 50-digit arithmetic (tests/data/4sps-spr.json), and against the lengths that the paper
// prints.
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/numbers.hpp>
#include <tests/plugins/four_sps_spr_cases.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::AngleAxisd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector, test::tolerance;

TEST_CASE("every reference case of the 4SPS-SPR comes out to nine digits") {
  const json file = test::reference("4sps-spr.json");
  REQUIRE(file["cases"].size() == 6);
  for (const json& c : file["cases"]) {
    const std::string name = c["name"];
    DYNAMIC_SECTION(name) {
      const json &in = c["input"], &out = c["output"];
      const Machine machine(test::four_sps_spr(), test::four_sps_spr_cases::parameters_of(c, file["meta"]));
      const State s = test::four_sps_spr_cases::state_of(machine, in);
      const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];

      check_equal("position", platform.origin, vector(out["p"]));
      for (int r = 0; r < 3; ++r)
        check_equal("rotation", platform.rotation.row(r).transpose(), vector(out["rotation"][static_cast<std::size_t>(r)]), 1.0);
      REQUIRE(s.derived.size() == 1);
      CHECK(machine.topology().derived[0].name == test::pose_names[test::four_sps_spr_cases::dependent_of(in)]);
      // A position, so that its home at zero is measured against the others.
      check_equal("dependent coordinate", VectorXd::Constant(1, s.derived[0].value), VectorXd::Constant(1, number(out["dependent"])),
                  platform.origin.norm());
      check_equal("velocity", platform.velocity, vector(out["v"]));
      check_equal("acceleration", platform.acceleration, vector(out["a"]));
      check_equal("angular velocity", platform.angular_velocity, vector(in["omega"]));
      check_equal("angular acceleration", platform.angular_acceleration, vector(in["epsilon"]));

      VectorXd lengths(5);
      for (int i = 0; i < 5; ++i) lengths(i) = s.actuators[static_cast<std::size_t>(i)].value;
      check_equal("lengths", lengths, vector(out["lengths"]));
      check_equal("rates", actuator_rates(s).head(5), vector(out["rates"]));
      check_equal("accelerations", actuator_accelerations(s).head(5), vector(out["accels"]));

      const auto a5 = static_cast<std::size_t>(test::joint_named(machine, "A5")),
                 b5 = static_cast<std::size_t>(test::joint_named(machine, "B5"));
      check_equal("n6", s.joints[b5].axis[0], vector(out["n6"]));
      check_equal("r6", s.joints[a5].centre - platform.origin, vector(out["A_minus_p_r6"]));

      const ClosedForm g = closed_form(machine, s, characteristic_length(machine));
      for (int i = 0; i < 6; ++i) {
        const VectorXd row = vector(out["G"][static_cast<std::size_t>(i)]);
        check_equal("G, force", g.jacobian.row(i).head(3).transpose(), row.head(3));
        check_equal("G, moment", g.jacobian.row(i).tail(3).transpose(), row.tail(3));
      }
      check_equal("det G", VectorXd::Constant(1, g.determinant), VectorXd::Constant(1, number(out["detG"])));
      check_equal("V^T H V", g.jacobian_rate * platform.twist(), vector(out["VtHV"]));

      check_equal("massless statics", closed_statics(g, test::four_sps_spr_cases::load_of(in)), vector(out["statics_massless"]));
    }
  }
}

TEST_CASE("joint angles of the reference cases come out to nine digits") {
  const json file = test::reference("4sps-spr.json");
  for (const json& c : file["cases"]) {
    const Machine machine(test::four_sps_spr(), test::four_sps_spr_cases::parameters_of(c, file["meta"]));
    const State s = test::four_sps_spr_cases::state_of(machine, c["input"]);
    const Closure closure(machine);
    const json& angles = c["output"]["angles"];
    const auto motion = [&](const std::string& joint) { return closure.motion(s.bodies, test::joint_named(machine, joint)).at(0); };
    for (std::size_t i = 0; i < 5; ++i) {
      const std::string n = std::to_string(i + 1);
      CAPTURE(c["name"], n);
      CHECK(std::abs(motion("A" + n) - number(angles["S_base_deg"][i]) * deg) < tolerance);
      if (i < 4) CHECK(std::abs(motion("B" + n) - number(angles["S_plat_deg"][i]) * deg) < tolerance);
    }
    CHECK(std::abs(motion("B5") - number(angles["R5_deg"]) * deg) < tolerance);  // of limb 5 against the platform, about n6
  }
}

TEST_CASE("six limb lengths that the paper prints come out within 0.05 mm") {
  // The printed end pose breaks the revolute joint's own constraint, so no mechanism can take it: the lengths are those of the declared
  // geometry at that pose, base joints and platform joints read off at home.
  const Machine machine = test::make_four_sps_spr();
  const Pose& home = machine.home_pose();
  const Vector3d home_at = machine.origin(home, machine.topology().platform);
  const auto length = [&](int limb, const Vector3d& p, const Eigen::Matrix3d& r) {
    const std::string n = std::to_string(limb);
    const Vector3d a = machine.centre(home, test::joint_named(machine, "A" + n));
    const Vector3d b = machine.centre(home, test::joint_named(machine, "B" + n)) - home_at;
    return (p + r * b - a).norm() * 1e3;
  };
  const Eigen::Matrix3d level = Eigen::Matrix3d::Identity(),
                        end_turn = (AngleAxisd(52.5 * deg, Vector3d::UnitZ()) * AngleAxisd(35 * deg, Vector3d::UnitY()) *
                                    AngleAxisd(-39.4 * deg, Vector3d::UnitX()))
                                       .toRotationMatrix();
  const Vector3d end(-0.1692, 0.5350, 0.4591);
  constexpr double printed = 0.05;  // [mm], half of the last digit printed
  CHECK(machine.rotation(home, machine.topology().platform).isIdentity(1e-15));
  CHECK(std::abs(length(4, home_at, level) - 627.3) < printed);
  CHECK(std::abs(length(5, home_at, level) - 633.4) < printed);
  CHECK(std::abs(length(1, end, end_turn) - 951.3) < printed);
  CHECK(std::abs(length(3, end, end_turn) - 520.0) < printed);
  CHECK(std::abs(length(4, end, end_turn) - 933.7) < printed);
  CHECK(std::abs(length(5, end, end_turn) - 1020.8) < printed);
}
