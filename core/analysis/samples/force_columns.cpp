#include <core/analysis/samples/force_columns.hpp>

#include <core/analysis/columns.hpp>

namespace pmreport::analysis {

ForceColumns::ForceColumns(const Topology& t, const std::function<double*(const std::string&)>& find)
    : total_power(find("total_power")),
      load_power(find("load_power")),
      kinetic_energy(find("kinetic_energy")),
      potential_energy(find("potential_energy")) {
  for (const Actuator& a : t.actuators) {
    const auto of = [&](const char* suffix) { return find(a.name + suffix); };
    actuators.push_back({of("_dynamic_force"), of("_load_force"), of("_gravity_force"), of("_inertia_force"), of("_power"),
                         of("_drive_force"), of("_drive_power"), of("_motor_torque"), of("_motor_speed"), of("_motor_power"),
                         of("_reflected_inertia")});
  }
  for (const Joint& j : t.joints) {
    OfJoint columns{find(j.name + "_force"), find(j.name + "_moment"), {}, {}};
    for (int c = 0; c < 6; ++c) {
      const auto at = static_cast<std::size_t>(c);
      columns.joint_axes[at] = find(reaction_column(j, c, false));
      columns.base_axes[at] = find(reaction_column(j, c, true));
    }
    joints.push_back(columns);
  }
  for (int limb = 1; limb <= limbs_of(t); ++limb) {
    std::array<double*, 6> columns{};
    for (std::size_t c = 0; c < 6; ++c) columns[c] = find(limb_column(limb, static_cast<int>(c)));
    limbs.push_back(columns);
  }
}

}  // namespace pmreport::analysis
