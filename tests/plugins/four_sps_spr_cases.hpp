// The reference cases of the 4SPS-SPR (tests/data/4sps-spr.json): the machine, the state, the load and the gravity that each speaks of.
#pragma once

#include <core/mechanics/model/state.hpp>
#include <tests/given/reference.hpp>
#include <tests/plugins/four_sps_spr.hpp>
#include <tests/plugins/turning.hpp>

namespace pmreport::test::four_sps_spr_cases {

inline Dependent dependent_of(const json& in) {
  const std::string axis = in["dependent_axis"];
  return axis == "X" ? x : axis == "Y" ? y : z;
}

// `meta` of the file tells the parameters that differ from the plugin's.
inline mechanics::ParameterValues parameters_of(const json& c, const json& meta) {
  std::map<std::string, std::vector<double>> changes{{"dependent", {static_cast<double>(dependent_of(c["input"]))}}};
  const std::string id = c["name"].get<std::string>().substr(0, 3);
  if (meta["other_parameters"].contains(id)) {
    const json& other = meta["other_parameters"][id];
    const json& i = other["I_o"];
    changes["revolute_axis"] = {number(other["n6p"][0]), number(other["n6p"][1]), number(other["n6p"][2])};
    changes["platform_inertia"] = {number(i[0][0]), number(i[1][1]), number(i[2][2]), number(i[0][1]), number(i[0][2]), number(i[1][2])};
  }
  return values_with(four_sps_spr(), changes);
}

inline mechanics::State state_of(const mechanics::Machine& machine, const json& in) {
  const Eigen::Vector3d angles(number(in["alpha"]), number(in["beta"]), number(in["gamma"]));  // Rz Ry Rx, as yaw, pitch and roll
  const AngleRates turning = angle_rates(angles, vector3(in["omega"]), vector3(in["epsilon"]));
  Eigen::VectorXd q(5), rate(5), acceleration(5);
  q << vector(in["p_free"]), angles;
  rate << vector(in["v_free"]), turning.rates;
  acceleration << vector(in["a_free"]), turning.accelerations;
  mechanics::State s;
  mechanics::evaluate(machine, q.data(), rate.data(), acceleration.data(), s);
  REQUIRE(s.status == PM_OK);
  return s;
}

inline mechanics::Vector6d load_of(const json& in) { return (mechanics::Vector6d() << vector(in["F"]), vector(in["T"])).finished(); }

inline Eigen::Vector3d gravity_of(const json& file) { return {0, 0, -number(file["meta"]["default_parameters"]["g"])}; }

}  // namespace pmreport::test::four_sps_spr_cases
