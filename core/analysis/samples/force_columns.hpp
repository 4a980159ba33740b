// Where the numbers of the sections dynamics, drives and reactions go: columns found by name once, not at every sample.
#pragma once

#include <pmreport/topology.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace pmreport::analysis {

// Each points to the first sample of a column; null: the run does not have it.
struct ForceColumns {
  struct OfActuator {
    double *force, *load, *gravity, *inertia, *power;
    double *drive_force, *drive_power, *motor_torque, *motor_speed, *motor_power, *reflected_inertia;
  };
  struct OfJoint {
    double *force, *moment;
    std::array<double*, 6> joint_axes, base_axes;
  };
  std::vector<OfActuator> actuators;
  std::vector<OfJoint> joints;
  std::vector<std::array<double*, 6>> limbs;
  double *total_power, *load_power, *kinetic_energy, *potential_energy;

  ForceColumns(const Topology& t, const std::function<double*(const std::string& name)>& find);
};

}  // namespace pmreport::analysis
