// The reference cases of the 2Q-SPR (tests/data/2q-spr.json): the machine, the state, the load and the gravity that each speaks of.
#pragma once

#include <tests/given/reference.hpp>
#include <tests/plugins/two_q_spr.hpp>

namespace pmreport::test::two_q_spr_cases {

// `meta` of the file tells the parameters that differ from the plugin's.
inline mechanics::ParameterValues parameters_of(const json& c, const json& meta) {
  std::map<std::string, std::vector<double>> changes;
  if (c["name"] == "B07_anisotropic") {
    const json& other = meta["B07_B08_parameters"];
    const json& i = other["I_o"];
    changes["platform_inertia"] = {number(i[0][0]), number(i[1][1]), number(i[2][2]), number(i[0][1]), number(i[0][2]), number(i[1][2])};
    const std::pair<const char*, const char*> inertias[] = {
        {"cylinder", "Iq"}, {"piston", "Ip"}, {"upper_beam", "Ig"}, {"lower_beam", "IG"}};
    for (const auto& [ours, theirs] : inertias) {
      changes[std::string(ours) + "_inertia"] = {number(other[std::string(theirs) + "_t"])};
      changes[std::string(ours) + "_axial_inertia"] = {number(other[std::string(theirs) + "_a"])};
    }
  }
  return values_with(two_q_spr(), changes);
}

inline mechanics::State state_of(const mechanics::Machine& machine, const json& in) {
  mechanics::State s = state_at(machine, vector(in["p_free"]), matrix(in["rotation"]), vector(in["v_free"]), vector3(in["omega"]),
                                vector(in["a_free"]), vector3(in["epsilon"]));
  REQUIRE(s.status == PM_OK);
  return s;
}

inline mechanics::Vector6d load_of(const json& in) { return (mechanics::Vector6d() << vector(in["F"]), vector(in["T"])).finished(); }

inline Eigen::Vector3d gravity_of(const json& file) { return {0, 0, -number(file["meta"]["default_parameters"]["g"])}; }

}  // namespace pmreport::test::two_q_spr_cases
