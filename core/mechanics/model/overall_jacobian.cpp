#include <core/mechanics/model/overall_jacobian.hpp>

#include <core/assertion.hpp>
#include <core/linear/square.hpp>

namespace pmreport::mechanics {

using linear::Matrix6d;

namespace {

// Of the magnitude that a row of G belongs to: an actuator, or a constraint wrench.
Sense sense_of_row(const Machine& m, int row) {
  const Topology& t = m.topology();
  return row < m.dof() ? t.actuators[static_cast<std::size_t>(row)].sense()
                       : t.constraints[static_cast<std::size_t>(row - m.dof())].sense();
}

}  // namespace

Matrix6d dimensionless(const Machine& machine, const Matrix6d& jacobian, double length) {
  PMREPORT_ASSERT(length > 0, "the characteristic length is positive");
  Matrix6d g = jacobian;
  g.rightCols<3>() /= length;
  for (int i = 0; i < 6; ++i)
    if (sense_of_row(machine, i) == Sense::rotary) g.row(i) *= length;
  return g;
}

Matrix6d unit_wrenches(const Matrix6d& jacobian, double length) {
  PMREPORT_ASSERT(length > 0, "the characteristic length is positive");
  Matrix6d g = jacobian;
  g.rightCols<3>() /= length;
  for (int i = 0; i < 6; ++i)
    if (const double size = g.row(i).norm(); size > 0) g.row(i) /= size;
  return g;
}

int side_of(const Matrix6d& jacobian, double length) {
  return jacobian.allFinite() ? linear::sign_of_determinant(unit_wrenches(jacobian, length)) : 0;
}

}  // namespace pmreport::mechanics
