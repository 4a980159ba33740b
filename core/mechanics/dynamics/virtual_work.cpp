#include <core/mechanics/dynamics/virtual_work.hpp>

#include <core/assertion.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/statics/statics.hpp>

namespace pmreport::mechanics {

using Eigen::Vector3d;
using Eigen::VectorXd;

// (1).
ForceShares virtual_work(const Machine& machine, const State& state, const Tangent& tangent, const Loading& loading) {
  PMREPORT_ASSERT(tangent.actuators.rows() == machine.dof(), "the tangent is that of the state");
  const linear::SmallFactorsOfTranspose solver(tangent.actuators.transpose());
  const auto forces = [&](const auto& rows, const auto& wrenches) -> SmallVector {
    return solver.solve(SmallVector(rows.transpose() * wrenches));
  };
  const auto platform = tangent.bodies.middleRows<6>(6 * machine.topology().platform - 6);
  return {forces(platform, -loading.platform), forces(tangent.bodies, -weights(machine, state, loading.gravity)),
          forces(tangent.bodies, inertial_wrenches(machine, state))};
}

SmallVector weight_forces(const Machine& machine, const State& state, const Vector3d& gravity) {
  const Tangent k = tangent(machine, state);
  return linear::SmallFactorsOfTranspose(k.actuators.transpose())
      .solve(SmallVector(-k.bodies.transpose() * weights(machine, state, gravity)));
}

// (2).
EquationsOfMotion equations_of_motion(const Machine& machine, const State& state, const Tangent& tangent, const Vector3d& gravity) {
  EquationsOfMotion e;
  const int m = machine.dof();
  e.mass = SmallMatrix::Zero(m, m);
  VectorXd of_rates = inertial_wrenches(machine, state);  // less what the accelerations demand
  SmallVector accelerations(m);
  for (int i = 0; i < m; ++i) accelerations(i) = state.coordinates[static_cast<std::size_t>(i)].acceleration;
  for (std::size_t b = 1; b < state.bodies.size(); ++b) {
    const auto row = 6 * static_cast<Eigen::Index>(b) - 6;
    const auto k = tangent.bodies.middleRows<6>(row);
    e.mass += k.transpose() * mass_matrix(machine.topology().bodies[b].inertia, state.bodies[b]) * k;
  }
  e.coriolis = tangent.bodies.transpose() * of_rates - e.mass * accelerations;
  e.gravity = -tangent.bodies.transpose() * weights(machine, state, gravity);
  return e;
}

// (3).
SmallVector reflected_inertia(const Tangent& tangent, const SmallMatrix& mass) {
  const SmallMatrix inverse = linear::inverse(tangent.actuators);
  return (inverse.transpose() * mass * inverse).diagonal();
}

}  // namespace pmreport::mechanics
