// Weights of all bodies at rest, against the reference cases without motion: their inverse dynamics is then load and weight alone.
#include <catch2/catch.hpp>

#include <core/mechanics/model/closed_form.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <nlohmann/json.hpp>
#include <tests/plugins/four_sps_spr.hpp>

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <fstream>

using namespace pmreport;
using namespace pmreport::mechanics;

TEST_CASE("at rest the actuators carry load and weights as the reference cases say") {
  const auto reference = nlohmann::json::parse(std::ifstream(TEST_DATA "/4sps-spr.json"));
  const double g = nlohmann::json::parse(std::string(reference["meta"]["default_parameters"]["g"]));  // "9.81"
  const Machine machine = test::make_four_sps_spr();
  int cases = 0;
  for (const auto& c : reference["cases"]) {
    const auto& in = c["input"];
    const bool still = c["name"] == "A01_home_static" || c["name"] == "A02_home_gravity" || c["name"] == "A03_tilt";
    if (!still) continue;
    CAPTURE(std::string(c["name"]));
    ++cases;
    const double q[5] = {in["p_free"][0], in["p_free"][1], in["alpha"], in["beta"], in["gamma"]}, zero[5] = {};
    State state;
    evaluate(machine, q, zero, zero, state);
    Vector6d load;
    for (int i = 0; i < 3; ++i) load(i) = in["F"][static_cast<std::size_t>(i)], load(i + 3) = in["T"][static_cast<std::size_t>(i)];
    const Eigen::Vector3d gravity(0, 0, -g);
    const Eigen::VectorXd forces = closed_statics(closed_form(machine, state, 0.1), load).head(5) + weight_forces(machine, state, gravity);

    // Relative to the largest force; a few digits are lost to the condition of G (about 200).
    const auto& expected = c["output"]["inverse_dynamics"];
    double largest = 0;
    for (std::size_t i = 0; i < 5; ++i) largest = std::max(largest, std::abs(double(expected[i])));
    for (std::size_t i = 0; i < 5; ++i) CHECK(std::abs(forces(static_cast<int>(i)) - double(expected[i])) < 1e-9 * largest);

    // The equilibrium of every body says the same.
    Eigen::VectorXd wrenches = weights(machine, state, gravity);
    wrenches.segment<6>(6 * machine.topology().platform - 6) += load;
    const GenericStatics whole = generic_statics(generic_model(machine, state), wrenches);
    for (int i = 0; i < 5; ++i) CHECK(std::abs(whole.actuator_forces(i) - forces(i)) < 1e-9 * largest);
  }
  CHECK(cases == 3);
}
