#include <core/mechanics/virtual_work.hpp>

#include <core/mechanics/generic_model.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Tangent tangent(const Machine& machine, const State& state) {
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  const std::size_t dof = static_cast<std::size_t>(machine.dof()), components = 1 + dof;
  std::vector<double> q(dof), x(layout.size() * components);
  for (std::size_t i = 0; i < dof; ++i) q[i] = state.coordinates[i].value;
  machine.place(PM_PARTIALS, 1, q.data(), x.data());

  Tangent out;
  out.bodies.resize(6 * (static_cast<int>(t.bodies.size()) - 1), machine.dof());
  out.actuators.resize(machine.dof(), machine.dof());
  for (std::size_t k = 0; k < dof; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    const auto vector = [&](std::size_t scalar) {
      return Vector3d(x[scalar * components + 1 + k], x[(scalar + 1) * components + 1 + k], x[(scalar + 2) * components + 1 + k]);
    };
    for (std::size_t i = 0; i < dof; ++i)
      out.actuators(static_cast<Eigen::Index>(i), column) = x[layout.actuator(static_cast<int>(i)) * components + 1 + k];
    for (std::size_t b = 1; b < t.bodies.size(); ++b) {
      const std::size_t at = layout.body(static_cast<int>(b));
      const Matrix3d& r = state.bodies[b].rotation;
      Vector3d turn;
      if (t.bodies[b].slender) {
        turn = r.col(2).cross(vector(at + 3));
      } else {  // dR R^T is skew: half the sum of (column of R) x (its derivative) is its axial vector
        Matrix3d rows;
        rows << vector(at + 3).transpose(), vector(at + 6).transpose(), vector(at + 9).transpose();
        turn = 0.5 * (r.col(0).cross(rows.col(0)) + r.col(1).cross(rows.col(1)) + r.col(2).cross(rows.col(2)));
      }
      out.bodies.block<6, 1>(6 * static_cast<Eigen::Index>(b) - 6, column) << vector(at), turn;
    }
  }
  return out;
}

ForceShares virtual_work(const Machine& machine, const State& state, const Tangent& tangent, const Loading& loading) {
  const auto solver = tangent.actuators.transpose().partialPivLu();
  const auto forces = [&](const VectorXd& wrenches) { return SmallVector(solver.solve(tangent.bodies.transpose() * wrenches)); };
  const int platform = 6 * machine.topology().platform - 6;
  return {SmallVector(solver.solve(-tangent.bodies.middleRows<6>(platform).transpose() * loading.platform)),
          forces(-weights(machine, state, loading.gravity)), forces(inertial_wrenches(machine, state))};
}

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

SmallVector reflected_inertia(const Tangent& tangent, const SmallMatrix& mass) {
  const SmallMatrix inverse = tangent.actuators.inverse();
  return (inverse.transpose() * mass * inverse).diagonal();
}

}  // namespace pmreport::mechanics
