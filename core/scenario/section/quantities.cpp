#include <core/scenario/section/quantities.hpp>

namespace pmreport::mechanics {

std::vector<Quantity> quantities_of(std::string_view section, std::size_t poses) {
  if (section == "mobility")
    return {{"mobility.links", "", "links, base included"},
            {"mobility.joints", "", "joints"},
            {"mobility.freedoms_sum", "", "sum of the joints' freedoms"},
            {"mobility.gruebler", "", "degrees of freedom by Grübler-Kutzbach, without redundant constraints"},
            {"mobility.rows", "", "constraints of the generic model"},
            {"mobility.rank", "", "rank of the constraints"},
            {"mobility.idle", "", "idle freedoms"},
            {"mobility.redundant", "", "redundant constraints"},
            {"mobility.freedoms", "", "degrees of freedom"},
            {"mobility.translations", "", "independent translations of the platform"},
            {"mobility.rotations", "", "independent rotations of the platform"}};
  if (section == "singularity") {
    std::vector<Quantity> out{{"singularity.crossings", "", "singular surfaces crossed by the motion"},
                              {"singularity.smallest_singular_value", "", "smallest singular value of G along the motion", false},
                              {"singularity.largest_condition", "", "largest condition number along the motion", false},
                              {"singularity.line_rank", "", "rank of the actuation lines at the worst pose of the motion"},
                              {"singularity.wrench_rank", "", "rank of the whole wrench system at the worst pose of the motion"}};
    for (std::size_t i = 1; i <= poses; ++i) {
      const std::string n = std::to_string(i);
      out.push_back({"singularity.line_rank_" + n, "", "rank of the actuation lines at pose " + n});
      out.push_back({"singularity.wrench_rank_" + n, "", "rank of the whole wrench system at pose " + n});
    }
    return out;
  }
  if (section == "assembly")
    return {{"assembly.modes", "", "real assembly modes"},
            {"assembly.own_working_mode", "", "real assembly modes in the working mode of the scenario"},
            {"assembly.nearest", "m", "least distance along the motion to another assembly mode", false}};
  if (section == "classification")
    return {{"classification.by_rule", "", "schemes that the rule admits"},
            {"classification.base_schemes", "", "base schemes of Table 1"},
            {"classification.six_chains", "", "schemes with six chains of Table 2"}};
  if (section == "dynamics")
    return {{"dynamics.peak_force", "N", "largest force of a linear actuator", false},
            {"dynamics.peak_torque", "N*m", "largest torque of a rotary actuator", false},
            {"dynamics.peak_power", "W", "largest power of any actuator", false},
            {"dynamics.work", "J", "work of the actuators over the motion", false},
            {"dynamics.regenerated", "J", "work that loads and inertia give back to actuators over the motion", false},
            {"dynamics.energy_drift", "J", "energy that a motion by forces loses or gains by integration", false}};
  if (section == "drives")
    return {{"drives.peak_torque", "N*m", "largest motor torque", false},
            {"drives.peak_speed", "rad/s", "largest motor speed", false},
            {"drives.peak_power", "W", "largest motor power", false}};
  if (section == "reactions")
    return {{"reactions.peak_force", "N", "largest force in any joint", false},
            {"reactions.peak_moment", "N*m", "largest moment in any joint", false},
            {"reactions.indeterminate", "", "components of joint reactions that rigid bodies do not determine"},
            {"reactions.self_stresses", "", "independent self-stresses"}};
  if (section == "speed")
    return {{"speed.scale", "", "how many times as fast the motion could run", false},
            {"speed.duration", "s", "duration of the motion at that speed", false}};
  return {};
}

std::vector<std::string> sections_with_quantities() {
  return {"mobility", "singularity", "assembly", "classification", "dynamics", "drives", "reactions", "speed"};
}

}  // namespace pmreport::mechanics
