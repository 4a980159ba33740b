#include <core/analysis/samples/force_columns.hpp>

#include <core/analysis/columns.hpp>
#include <core/mechanics/machine/limb_line.hpp>

namespace pmreport::analysis {

ForceColumns::ForceColumns(const Topology& t, const std::function<double*(const ColumnId&)>& find)
    : total_power(find(column_of(OfMachine::total_power))),
      load_power(find(column_of(OfMachine::load_power))),
      kinetic_energy(find(column_of(OfMachine::kinetic_energy))),
      potential_energy(find(column_of(OfMachine::potential_energy))) {
  for (const Actuator& a : t.actuators) {
    const auto of = [&](OfActuator what) { return find(column_of(a, what)); };
    actuators.push_back({of(OfActuator::dynamic_force), of(OfActuator::load_force), of(OfActuator::gravity_force),
                         of(OfActuator::inertia_force), of(OfActuator::power), of(OfActuator::drive_force), of(OfActuator::drive_power),
                         of(OfActuator::motor_torque), of(OfActuator::motor_speed), of(OfActuator::motor_power),
                         of(OfActuator::reflected_inertia)});
  }
  for (const Joint& j : t.joints) {
    JointColumns columns{find(column_of(j, OfJoint::force)), find(column_of(j, OfJoint::moment)), {}, {}};
    for (int c = 0; c < 6; ++c) {
      const auto at = static_cast<std::size_t>(c);
      columns.joint_axes[at] = find(reaction_column(j, c, false));
      columns.base_axes[at] = find(reaction_column(j, c, true));
    }
    joints.push_back(columns);
  }
  for (int limb = 1; limb <= mechanics::limbs_of(t); ++limb) {
    std::array<double*, 6> columns{};
    for (std::size_t c = 0; c < 6; ++c) columns[c] = find(limb_column(limb, static_cast<int>(c)));
    limbs.push_back(columns);
  }
}

}  // namespace pmreport::analysis
