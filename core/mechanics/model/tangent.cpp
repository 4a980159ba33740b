#include <core/mechanics/model/tangent.hpp>

#include <core/assertion.hpp>
#include <core/linear/singular_values.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;

namespace {

using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 6>;  // partials of a scalar by the coordinates

// Columns of the platform as twists (v; L w), each of unit size.
MatrixXd platform_columns(const Machine& machine, const Tangent& t, double length) {
  MatrixXd columns = t.bodies.middleRows<6>(6 * machine.topology().platform - 6);
  columns.bottomRows<3>() *= length;
  for (Index i = 0; i < columns.cols(); ++i)
    if (const double size = columns.col(i).norm(); size > 0) columns.col(i) /= size;
  return columns;
}

// Of a rotation R, dR R^T is skew, and its entries are those of its axial vector: dR R^T (2, 1) = (row 2 of dR) . (row 1 of R) is the
// first. A slender body turns about n x dn.
void by_coordinates(const Machine& machine, const State& state, Tangent& out) {
  const Topology& t = machine.topology();
  const Layout& layout = machine.layout();
  const Index dof = machine.dof(), components = 1 + dof;
  out.placement_partials.resize(layout.size() * static_cast<std::size_t>(components));
  SmallVector q(dof);
  for (Index i = 0; i < dof; ++i) q(i) = state.coordinates[static_cast<std::size_t>(i)].value;
  machine.place(PM_PARTIALS, 1, q.data(), out.placement_partials.data());
  const auto partials = [&](std::size_t scalar) {
    return Eigen::Map<const Row>(&out.placement_partials[scalar * static_cast<std::size_t>(components)] + 1, dof);
  };

  out.by_coordinates = true;
  out.bodies.resize(6 * (static_cast<Index>(t.bodies.size()) - 1), dof);
  out.actuators.resize(dof, dof);
  for (int i = 0; i < machine.dof(); ++i) out.actuators.row(i) = partials(layout.actuator(i));
  for (std::size_t b = 1; b < t.bodies.size(); ++b) {
    const std::size_t at = layout.body(static_cast<int>(b)), turned = at + 3;
    const Matrix3d& r = state.bodies[b].rotation;
    const auto first = 6 * static_cast<Index>(b) - 6;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      const auto row = first + static_cast<Index>(k), ri = static_cast<Index>(i), rj = static_cast<Index>(j);
      out.bodies.row(row) = partials(at + k);
      if (t.bodies[b].slender)
        out.bodies.row(row + 3) = r(ri, 2) * partials(turned + j) - r(rj, 2) * partials(turned + i);
      else
        out.bodies.row(row + 3) =
            r(ri, 0) * partials(turned + 3 * j) + r(ri, 1) * partials(turned + 3 * j + 1) + r(ri, 2) * partials(turned + 3 * j + 2);
    }
  }
}

// (1). Of the motions that the constraints allow, those that move the platform most, and none but them: the others are idle freedoms.
void by_constraints(const Machine& machine, const State& state, double length, Tangent& out) {
  const GenericModel model = generic_model(machine, state);
  MatrixXd motions = linear::null_space_by_singular_values(unit_rows(model.constraints, length));
  const Index dof = machine.dof(), at = 6 * static_cast<Index>(machine.topology().platform) - 6;
  if (motions.cols() < dof) return;
  motions = motions * linear::left_singular(motions.middleRows<6>(at).transpose()).vectors.leftCols(dof);
  for (Index body = 0; body < motions.rows(); body += 6) motions.middleRows<3>(body + 3) /= length;
  out.by_coordinates = false;
  out.bodies = motions;
  out.actuators = model.actuation * motions;
}

}  // namespace

Tangent tangent(const Machine& machine, const State& state) {
  Tangent out;
  tangent(machine, state, out);
  return out;
}

void tangent(const Machine& machine, const State& state, Tangent& out) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  by_coordinates(machine, state, out);
  const double length = characteristic_length(machine);
  const Eigen::VectorXd pivots = linear::pivots(platform_columns(machine, out, length));
  if (pivots(pivots.size() - 1) < poor_chart) by_constraints(machine, state, length, out);
}

std::optional<ChartFault> chart_fault(const Machine& machine, const SmallVector& coordinates, double length) {
  const State state = state_at_rest(machine, coordinates);
  if (state.status != PM_OK) return std::nullopt;
  Tangent t;
  by_coordinates(machine, state, t);
  // The singular values of the transpose are the same, and what belongs to the smallest is a direction in the coordinates.
  const linear::LeftSingular svd = linear::left_singular(platform_columns(machine, t, length).transpose());
  const Index last = svd.values.size() - 1;
  ChartFault fault{svd.values(last), {}};
  if (!(fault.quality < nearly_singular)) return std::nullopt;
  const Eigen::VectorXd direction = svd.vectors.col(last).cwiseAbs();
  constexpr double part = 0.1;  // of the largest: it takes part
  for (Index i = 0; i < direction.size(); ++i)
    if (direction(i) > part * direction.maxCoeff()) fault.coordinates.push_back(static_cast<int>(i));
  return fault;
}

std::string in_words(const Machine& machine, const ChartFault& fault) {
  std::vector<std::string> names;
  bool turn = true;
  for (const int i : fault.coordinates) {
    const Coordinate& c = machine.topology().coordinates[static_cast<std::size_t>(i)];
    names.push_back(c.name);
    turn = turn && c.sense() == Sense::rotary;
  }
  const char* nearly = fault.quality < poor_chart ? "" : "nearly ";
  if (names.size() == 1)
    return fmt::format("{} does not move the platform there: this coordinate is singular, the machine is not", names.front());
  return fmt::format("{} {} the platform {}{} there: these coordinates are singular, the machine is not", listed(names, "and"),
                     turn ? "turn" : "move", nearly, turn ? "about one axis" : "in one way");
}

}  // namespace pmreport::mechanics
