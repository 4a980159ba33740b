#include <core/linear/subspace.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/mechanics/model/generic_model.hpp>

namespace pmreport::mechanics {

using Eigen::MatrixXd;

Mobility mobility(const Machine& machine, const State& state) {
  const Topology& t = machine.topology();
  const GenericModel model = generic_model(machine, state);
  const int columns = static_cast<int>(model.constraints.cols()), rows = static_cast<int>(model.constraints.rows());
  const int n_actuators = static_cast<int>(t.actuators.size());
  MatrixXd all(rows + 6 + n_actuators, columns);
  all << model.constraints, MatrixXd::Zero(6, columns), model.actuation;
  all.block<6, 6>(rows, 6 * t.platform - 6).setIdentity();
  all = unit_rows(all, characteristic_length(machine));

  Mobility m;
  m.bodies = static_cast<int>(t.bodies.size());
  m.joints = static_cast<int>(t.joints.size());
  for (const Joint& j : t.joints) m.freedoms_sum += freedoms_of(j.kind);
  m.gruebler = 6 * (m.bodies - m.joints - 1) + m.freedoms_sum - t.idle;
  m.rows = rows;
  m.rank = linear::rank(all.topRows(rows).transpose());
  m.idle = columns - linear::rank(all.transpose());
  m.freedoms = columns - m.rank - m.idle;
  m.redundant = rows - m.rank;
  return m;
}

}  // namespace pmreport::mechanics
