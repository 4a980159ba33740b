#include <core/mechanics/dynamics/virtual_work.hpp>

#include <core/assertion.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/statics/statics.hpp>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 6>;  // partials of a scalar by the coordinates

}  // namespace

Tangent tangent(const Machine& machine, const State& state) {
  Tangent out;
  tangent(machine, state, out);
  return out;
}

// Of a rotation R, dR R^T is skew, and its entries are those of its axial vector: dR R^T (2, 1) = (row 2 of dR) . (row 1 of R) is the
// first. A slender body turns about n x dn.
void tangent(const Machine& machine, const State& state, Tangent& out) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  const Eigen::Index dof = machine.dof(), components = 1 + dof;
  out.placement_partials.resize(layout.size() * static_cast<std::size_t>(components));
  SmallVector q(dof);
  for (Eigen::Index i = 0; i < dof; ++i) q(i) = state.coordinates[static_cast<std::size_t>(i)].value;
  machine.place(PM_PARTIALS, 1, q.data(), out.placement_partials.data());
  const auto partials = [&](std::size_t scalar) {
    return Eigen::Map<const Row>(&out.placement_partials[scalar * static_cast<std::size_t>(components)] + 1, dof);
  };

  out.bodies.resize(6 * (static_cast<Eigen::Index>(t.bodies.size()) - 1), dof);
  out.actuators.resize(dof, dof);
  for (int i = 0; i < machine.dof(); ++i) out.actuators.row(i) = partials(layout.actuator(i));
  for (std::size_t b = 1; b < t.bodies.size(); ++b) {
    const std::size_t at = layout.body(static_cast<int>(b)), turned = at + 3;
    const Matrix3d& r = state.bodies[b].rotation;
    const auto first = 6 * static_cast<Eigen::Index>(b) - 6;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const auto row = first + static_cast<Eigen::Index>(k), ri = static_cast<Eigen::Index>(i), rj = static_cast<Eigen::Index>(j);
      out.bodies.row(row) = partials(at + k);
      if (t.bodies[b].slender)
        out.bodies.row(row + 3) = r(ri, 2) * partials(turned + j) - r(rj, 2) * partials(turned + i);
      else
        out.bodies.row(row + 3) =
            r(ri, 0) * partials(turned + 3 * j) + r(ri, 1) * partials(turned + 3 * j + 1) + r(ri, 2) * partials(turned + 3 * j + 2);
    }
  }
}

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
