// The P(2PRPU)/PRPS against closed forms that an independent multibody model confirmed (tests/data/p2prpu-prps.json).
#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/numbers.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/p2prpu_prps.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector, test::vector3, test::matrix, test::tolerance, test::values;

namespace {

constexpr const char *limbs[] = {"1", "2", "3"}, *platform_joints[] = {"S1", "U2", "U3"};

ParameterValues parameters_of(const json& geometry) {
  return test::values_with(test::p2prpu_prps(), {{"gauge", {number(geometry["L"])}},
                                                 {"platform_width", {number(geometry["e"])}},
                                                 {"platform_arm", {number(geometry["h"])}},
                                                 {"sigma", {number(geometry["sigma"]) > 0 ? 1.0 : 0.0}}});
}

VectorXd coordinates_of(const json& pose) {
  VectorXd q(5);
  q << number(pose["x"]), number(pose["y"]), number(pose["z"]), number(pose["alpha"]), number(pose["beta"]);
  return q;
}

std::size_t body_named(const Machine& machine, const std::string& name) {
  const auto& bodies = machine.topology().bodies;
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == name; });
  REQUIRE(found != bodies.end());
  return static_cast<std::size_t>(found - bodies.begin());
}

// Every row of `expected` against the row of `seen`, a vector each.
void check_rows(const char* what, const Eigen::MatrixXd& seen, const Eigen::MatrixXd& expected) {
  REQUIRE(seen.rows() == expected.rows());
  for (Eigen::Index i = 0; i < seen.rows(); ++i) check_equal(what, seen.row(i).transpose(), expected.row(i).transpose());
}

}  // namespace

TEST_CASE("every reference case of the P(2PRPU)/PRPS comes out to nine digits") {
  const json file = test::reference("p2prpu-prps.json");
  REQUIRE(file["cases"].size() == 7);
  for (const json& c : file["cases"]) {
    const std::string name = c["name"];
    DYNAMIC_SECTION(name) {
      const Machine machine(test::p2prpu_prps(), parameters_of(c["geometry"]));
      const VectorXd q = coordinates_of(c["pose"]);
      const State s = test::state_at(machine, q, vector(c["pose_rate"]), vector(c["pose_accel"]));
      const BodyState& platform = s.bodies[static_cast<std::size_t>(machine.topology().platform)];
      const auto joint = [&](const std::string& of) { return s.joints[static_cast<std::size_t>(test::joint_named(machine, of))]; };

      check_rows("rotation", platform.rotation, matrix(c["R"]));
      check_equal("angular velocity", platform.angular_velocity, vector(c["omega"]));
      check_equal("angular acceleration", platform.angular_acceleration, vector(c["eps"]));
      check_equal("actuators", values(s.actuators), vector(c["q"]));
      check_equal("actuator rates", values(s.actuators, &Scalar::rate), vector(c["qd"]));
      check_equal("actuator accelerations", values(s.actuators, &Scalar::acceleration), vector(c["qdd"]));

      for (std::size_t i = 0; i < 3; ++i) {
        const std::string n = limbs[i];
        CAPTURE(n);
        const BodyState& upper = s.bodies[body_named(machine, "upper " + n)];
        check_equal("A", joint("R" + n + "1").centre, vector(c["A"][i]));
        check_equal("C", joint(platform_joints[i]).centre, vector(c["C"][i]));
        check_equal("e", joint(platform_joints[i]).centre - platform.origin, vector(c["e_vec"][i]));
        check_equal("direction of the limb", joint("P" + n).axis[0], vector(c["delta"][i]));
        check_equal("velocity of C", upper.velocity, vector(c["vC"][i]));
        check_equal("acceleration of C", upper.acceleration, vector(c["aC"][i]));
        // Limb 1 turns about Y, limbs 2 and 3 turn about X.
        const Vector3d axis = i == 0 ? Vector3d::UnitY() : Vector3d::UnitX();
        check_equal("turning of the limb", upper.angular_velocity, axis * number(c["theta_dot"][i]));
        check_equal("turning of the limb, rate", upper.angular_acceleration, axis * number(c["theta_ddot"][i]));
        check_equal("transmission index", test::reading(machine, q, "mu" + n), number(c["mu"][i]));
        check_equal("angle against the platform's normal", test::reading(machine, q, std::string(platform_joints[i]) + "_tilt"),
                    number(c["S_U_angle_deg"][i]) * deg);
      }

      check_equal("transmission index of the mechanism", test::reading(machine, q, "mu"), number(c["mu_min"]));

      const ClosedForm g = closed_form(machine, s, characteristic_length(machine));
      check_rows("J6", g.jacobian, matrix(c["J6"]));
      check_equal("n", g.jacobian.row(5).tail<3>().transpose(), vector(c["n"]));
      check_equal("det J6, which is det J_D", g.determinant, number(c["det_J_D"]));
      const std::vector<Eigen::MatrixXd> given = machine.matrices({q.data(), 5}, machine.pose({q.data(), 5}));
      REQUIRE(given.size() == 2);
      check_rows("J_D", given[1], matrix(c["J_D"]));

      const Vector6d forces = closed_statics(g, vector(c["wrench_ext_at_o"]));
      check_equal("actuator forces", forces.head<5>(), vector(c["static_actuator_force_for_wrench"]));
      check_equal("constraint couple", forces(5), number(c["static_constraint_torque_total"]), forces.lpNorm<Eigen::Infinity>());
    }
  }
}

TEST_CASE("joint angles of the P(2PRPU)/PRPS's reference cases come out to nine digits") {
  for (const json& c : test::reference("p2prpu-prps.json")["cases"]) {
    const Machine machine(test::p2prpu_prps(), parameters_of(c["geometry"]));
    const State s = test::state_at(machine, coordinates_of(c["pose"]));
    const Closure closure(machine);
    const auto motion = [&](const std::string& joint) { return closure.motion(s.bodies, test::joint_named(machine, joint)); };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string n = limbs[i];
      CAPTURE(c["name"], n);
      // The limb at home, in its plane: its angle from Z, positive about Y, and about X.
      const Vector3d limb = machine.centre(machine.home_pose(), test::joint_named(machine, platform_joints[i])) -
                            machine.centre(machine.home_pose(), test::joint_named(machine, "R" + n + "1"));
      const double home = i == 0 ? std::atan(limb.x() / limb.z()) : std::atan(-limb.y() / limb.z());
      const double angle = home + motion("R" + n + "1").at(0);
      CHECK(std::abs(std::abs(angle) - number(c["theta_deg"][i]) * deg) < tolerance);
      if (i == 0) continue;
      const std::vector<double> u = motion(platform_joints[i]);
      CHECK(std::abs(u.at(0) - (number(c["pose"]["alpha"]) - angle + home)) < tolerance);
      CHECK(std::abs(u.at(1) - number(c["pose"]["beta"])) < tolerance);
    }
  }
}

TEST_CASE("the P(2PRPU)/PRPS declares the masses of its reference model") {
  const json bodies = test::reference("p2prpu-prps.json")["bodies"];
  for (const double side : {0.0, 1.0}) {
    const Machine machine(test::p2prpu_prps(), test::values_with(test::p2prpu_prps(), {{"sigma", {side}}}));
    const auto inertia = [&](const std::string& name) { return machine.topology().bodies[body_named(machine, name)].inertia; };
    const auto check = [&](const std::string& name, const json& expected, const Vector3d& centre) {
      CAPTURE(side, name);
      const Inertia i = inertia(name);
      CHECK(i.mass == number(expected["m"]));
      CHECK((i.centre - centre).norm() < 1e-15);
      CHECK((i.about_centre - Eigen::Matrix3d(vector3(expected["I"]).asDiagonal())).norm() < 1e-15);
    };
    CHECK(inertia("carriage").mass == number(bodies["carriageX"]["m"]));
    CHECK(inertia("slider").mass == number(bodies["sliderY"]["m"]));
    check("platform", bodies["platform"], vector3(bodies["platform"]["c"]) * (side == 0 ? 1.0 : -1.0));  // towards C1
    for (const std::string n : limbs) {
      check("lower " + n, bodies["lower"], {0, 0, number(bodies["lower"]["c"])});
      check("upper " + n, bodies["upper"], {0, 0, -number(bodies["upper"]["c"])});
    }
  }
}
