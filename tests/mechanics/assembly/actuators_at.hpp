// What the tests of assembly modes have in common.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>

#include <catch2/catch.hpp>

namespace pmreport::test {

inline Eigen::VectorXd actuators_at(const mechanics::Machine& machine, const Eigen::VectorXd& q) {
  const mechanics::Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
  REQUIRE(pose.status == PM_OK);
  return Eigen::Map<const Eigen::VectorXd>(pose.numbers.data() + machine.layout().actuator(0), machine.dof());
}

// A short search: it is enough for mechanisms of a test, which are not compiled for speed.
inline mechanics::AssemblyOptions shortly() {
  mechanics::AssemblyOptions o;
  o.quiet_arrivals = 60;
  o.most_starts = 150;
  o.joint_starts = 0;
  return o;
}

inline mechanics::AssemblyModes modes_at(const mechanics::Machine& machine, const Eigen::VectorXd& q) {
  return find_assembly_modes(machine, actuators_at(machine, q), q, shortly());
}

}  // namespace pmreport::test
