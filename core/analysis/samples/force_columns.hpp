// Where the numbers of the sections dynamics, drives and reactions go: columns found once, not at every sample.
#pragma once

#include <core/analysis/column_names.hpp>
#include <pmreport/topology.hpp>

#include <array>
#include <functional>
#include <vector>

namespace pmreport::analysis {

// Each points to the first sample of a column; null: the run does not have it.
struct ForceColumns {
  struct ActuatorColumns {
    double *force, *load, *gravity, *inertia, *power;
    double *drive_force, *drive_power, *motor_torque, *motor_speed, *motor_power, *reflected_inertia;
  };
  struct JointColumns {
    double *force, *moment;
    std::array<double*, 6> joint_axes, base_axes;
  };
  std::vector<ActuatorColumns> actuators;
  std::vector<JointColumns> joints;
  std::vector<std::array<double*, 6>> limbs;
  double *total_power, *load_power, *kinetic_energy, *potential_energy;

  ForceColumns(const Topology& t, const std::function<double*(const ColumnId& id)>& find);
};

}  // namespace pmreport::analysis
