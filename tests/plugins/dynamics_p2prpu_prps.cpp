// Inverse dynamics and joint reactions of the P(2PRPU)/PRPS against a separately derived model (tests/data/p2prpu-prps.json).
#include <tests/plugins/dynamics.hpp>
#include <tests/plugins/p2prpu_prps.hpp>

using namespace pmreport;
using namespace pmreport::mechanics;
using Eigen::Vector3d;
using Eigen::VectorXd;
using nlohmann::json;
using test::check_equal, test::number, test::vector;

namespace {

Machine p2prpu_prps_of(const json& c) {
  const json& g = c["geometry"];
  const pm_mechanism& table = test::p2prpu_prps();
  return Machine(table, test::values_with(table, {{"gauge", {number(g["L"])}},
                                                  {"platform_width", {number(g["e"])}},
                                                  {"platform_arm", {number(g["h"])}},
                                                  {"sigma", {test::choice(table, "sigma", g["sigma"] == 1 ? "+1" : "-1")}}}));
}
VectorXd coordinates_of(const json& c) {
  VectorXd q(5);
  const char* names[] = {"x", "y", "z", "alpha", "beta"};
  for (int i = 0; i < 5; ++i) q(i) = number(c["pose"][names[i]]);
  return q;
}
// The line n = X x y_m about which the limbs 2 and 3 hold the platform.
Vector3d normal(const json& c) { return vector(c["n"]); }

}  // namespace

TEST_CASE("actuator forces of the P(2PRPU)/PRPS's reference cases come out to nine digits") {
  const json file = test::reference("p2prpu-prps.json");
  REQUIRE(file["cases"].size() == 7);
  for (const json& c : file["cases"]) DYNAMIC_SECTION(c["name"].get<std::string>()) {
      const Machine machine = p2prpu_prps_of(c);
      const State s = test::state_at(machine, coordinates_of(c), vector(c["pose_rate"]), vector(c["pose_accel"]));
      const test::Dynamics d(machine, s, {vector(c["wrench_ext_at_o"]), vector(c["gravity"])});
      d.check_actuators(vector(c["tau_inverse_dynamics"]));
    }
}

TEST_CASE("at rest and without weights the P(2PRPU)/PRPS's limbs hold the load as the reference cases say") {
  const json file = test::reference("p2prpu-prps.json");
  for (const json& c : file["cases"]) {
    CAPTURE(c["name"]);
    const Machine machine = p2prpu_prps_of(c);
    const State s = test::state_at(machine, coordinates_of(c));
    const Vector6d load = vector(c["wrench_ext_at_o"]);
    if (load.isZero()) continue;
    const test::Dynamics d(machine, s, {load, Vector3d::Zero()});
    d.check_actuators(vector(c["static_actuator_force_for_wrench"]));

    // The couple along n that limbs 2 and 3 give together, about o. Of their forces only those along X have a moment about n, as C2 and C3
    // lie along y_m, in the plane of the limbs.
    double couple = 0, x_forces = 0;
    for (const std::string limb : {"2", "3"}) {
      const Vector3d force = d.force_on("platform", "U" + limb), arm = d.joint("U" + limb).centre - s.bodies[1].origin;
      couple += (d.moment_on("platform", "U" + limb) + arm.cross(force)).dot(normal(c));
      x_forces += force.x();
    }
    check_equal("couple along n", couple, number(c["static_constraint_torque_total"]), load.lpNorm<Eigen::Infinity>());
    check_equal("forces along X", x_forces, d.reactions.actuator_forces(0), load.lpNorm<Eigen::Infinity>());
  }
}

TEST_CASE("two self-stresses of the P(2PRPU)/PRPS pass between limbs 2 and 3") {
  const json file = test::reference("p2prpu-prps.json");
  for (const json& c : file["cases"]) {
    CAPTURE(c["name"]);
    const Machine machine = p2prpu_prps_of(c);
    const State s = test::state_at(machine, coordinates_of(c), vector(c["pose_rate"]), vector(c["pose_accel"]));
    const test::Dynamics d(machine, s, {vector(c["wrench_ext_at_o"]), vector(c["gravity"])});
    CHECK(d.reactions.stresses.size() == 2);
    d.check_least_norm();
    for (const char* joint : {"PX", "PY", "R11", "P1", "S1"}) {
      CAPTURE(joint);
      CHECK(d.unique(joint));
    }
    for (const std::string limb : {"2", "3"})
      for (const std::string& joint : {"R" + limb + "1", "P" + limb, "U" + limb}) {
        CAPTURE(joint);
        CHECK_FALSE(d.unique(joint, 6));                             // force along X
        for (const int base : {7, 8}) CHECK(d.unique(joint, base));  // along Y and Z
      }
    for (const auto& stress : d.reactions.stresses) {
      const Vector6d &two = stress[static_cast<std::size_t>(test::joint_named(machine, "U2"))],
                     &three = stress[static_cast<std::size_t>(test::joint_named(machine, "U3"))];
      const double size = std::max({two.head<3>().norm(), two.tail<3>().norm() / d.length(), three.tail<3>().norm() / d.length()});
      for (const Vector6d& w : {two, three}) {
        CHECK(w.segment<2>(1).norm() < test::tolerance * size);
        CHECK(w.tail<3>().cross(normal(c)).norm() < test::tolerance * size * d.length());
      }
      // F_2x = -F_3x; their couple about n, e F_2x, is balanced by T_c2 + T_c3.
      const double e = number(c["geometry"]["e"]);
      CHECK(std::abs(two(0) + three(0)) < test::tolerance * size);
      CHECK(std::abs((two + three).tail<3>().dot(normal(c)) - e * two(0)) < test::tolerance * size * d.length());
    }
  }
}
