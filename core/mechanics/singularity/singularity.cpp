#include <core/mechanics/singularity/singularity.hpp>

#include <core/assertion.hpp>
#include <core/linear/singular_values.hpp>
#include <core/linear/square.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// Nothing where the pose cannot be assembled, or the plugin gives no G.
std::optional<Matrix6d> jacobian_at(const Machine& machine, const VectorXd& coordinates) {
  const Pose pose = machine.pose({coordinates.data(), static_cast<std::size_t>(coordinates.size())});
  if (pose.status != PM_OK) return std::nullopt;
  const Jacobian g = machine.jacobian(pose);
  return g.known() ? std::optional(g.matrix) : std::nullopt;
}

// Of sorted singular values the one after which only zeros are expected.
double margin(const MatrixXd& m, Index expected_rank) {
  if (expected_rank < 1 || m.size() == 0) return 0;  // a platform alone has no other bodies
  const VectorXd sigma = linear::singular_values(m);
  return expected_rank <= sigma.size() ? sigma(expected_rank - 1) : 0.0;
}

}  // namespace

double Conditioning::condition() const { return smallest > 0 ? largest / smallest : std::numeric_limits<double>::infinity(); }

Conditioning conditioning(const Machine& machine, const Matrix6d& jacobian, double length) {
  const Matrix6d g = dimensionless(machine, jacobian, length);
  const linear::RightSingular svd = linear::right_singular(g);
  Conditioning c{linear::determinant(g), svd.values(5), svd.values(0), svd.vectors.col(5)};
  c.escape.tail<3>() /= length;
  // A singular vector has no sign of its own: the largest component is positive.
  Index largest;
  c.escape.cwiseAbs().maxCoeff(&largest);
  if (c.escape(largest) < 0) c.escape = -c.escape;
  return c;
}

LineRanks line_ranks(const Machine& machine, const Matrix6d& jacobian, double length) {
  Matrix6d rows = jacobian;
  LineRanks r;
  for (int i = 0; i < 6; ++i) {
    const Screw screw = screw_of_wrench(rows.row(i).transpose(), Eigen::Vector3d::Zero(), length);
    if (i < machine.dof()) r.pitch.push_back(screw.pitch);
    rows.row(i).tail<3>() /= length;
    const double size = screw.is_free() ? rows.row(i).tail<3>().norm() : rows.row(i).head<3>().norm();
    if (size > 0) rows.row(i) /= size;  // a row of zeros has no direction, and adds nothing to a rank
  }
  // By singular values, as the literature has it; a pivot could be small without one.
  r.lines = linear::rank_by_singular_values(rows.topRows(machine.dof()));
  r.wrenches = linear::rank_by_singular_values(rows);
  return r;
}

LockedFreedoms locked_freedoms(const Machine& machine, const State& state, const Mobility& at_home, double length) {
  const GenericModel model = generic_model(machine, state);
  const Index columns = model.constraints.cols(), rows = model.constraints.rows(), drives = model.actuation.rows();
  const Index at = 6 * static_cast<Index>(machine.topology().platform) - 6;
  const MatrixXd phi = unit_rows(model.constraints, length), drive = unit_rows(model.actuation, length);
  LockedFreedoms f;

  MatrixXd all(rows + drives, columns);
  all << phi, drive;
  f.escapes.origin = state.bodies[static_cast<std::size_t>(machine.topology().platform)].origin;
  f.escapes.basis = linear::column_space(linear::null_space(all).middleRows(at, 6), 1);
  f.escapes.basis.bottomRows(3) /= length;
  f.platform = f.escapes.dimension();                                   // (2)
  f.free = linear::rank(linear::null_space(phi).middleRows(at, 6), 1);  // (3)

  MatrixXd rest(rows, columns - 6), rest_drive(drives, columns - 6);
  rest << phi.leftCols(at), phi.rightCols(columns - 6 - at);
  rest_drive << drive.leftCols(at), drive.rightCols(columns - 6 - at);
  f.actuators = linear::rank(rest_drive * linear::null_space(rest), 1);  // (4)
  f.inverse_margin = margin(rest, columns - 6 - at_home.idle);
  f.constraint_margin = margin(phi, at_home.rank);
  return f;
}

SingularityType type_of(const LockedFreedoms& f, int dof) {
  if (f.free > dof) return SingularityType::constraint;
  if (f.platform > 0) return f.actuators > 0 ? SingularityType::both : SingularityType::direct;
  return f.actuators > 0 ? SingularityType::inverse : SingularityType::regular;
}

std::optional<Singularity> singularity_at(const Machine& machine, const VectorXd& coordinates, const Mobility& at_home, double length) {
  Singularity s;
  s.coordinates = coordinates;
  s.state = state_at_rest(machine, coordinates);
  const std::optional<Matrix6d> g = jacobian_at(machine, coordinates);
  if (s.state.status != PM_OK || !g) return std::nullopt;
  s.jacobian = *g;
  s.conditioning = conditioning(machine, *g, length);
  s.ranks = line_ranks(machine, *g, length);
  s.freedoms = locked_freedoms(machine, s.state, at_home, length);
  s.type = type_of(s.freedoms, machine.dof());
  return s;
}

double dimensionless_determinant(const Machine& machine, const VectorXd& coordinates, double length) {
  const std::optional<Matrix6d> g = jacobian_at(machine, coordinates);
  return g ? linear::determinant(dimensionless(machine, *g, length)) : nan;
}

std::optional<WrenchDeterminant> wrench_determinant(const Machine& machine, const VectorXd& coordinates, double length) {
  const std::optional<Matrix6d> g = jacobian_at(machine, coordinates);
  if (!g) return std::nullopt;
  return WrenchDeterminant{linear::determinant(unit_wrenches(*g, length)), side_of(*g, length)};
}

bool singular_everywhere(const Machine& machine, double length) {
  constexpr int looked_at = 16;
  const auto singular = [&](const VectorXd& q) {
    const auto d = wrench_determinant(machine, q, length);
    return d && d->side == 0;
  };
  return singular(machine.home()) && std::ranges::all_of(random_poses(machine, looked_at, 1), singular);
}

std::optional<OnSurface> onto_surface(const Machine& machine, const VectorXd& coordinates, double length, double reach) {
  const auto& declared = machine.topology().coordinates;
  const auto unit = [&](int i) { return size_of(declared[static_cast<std::size_t>(i)].sense(), length); };
  const auto det = [&](int i, double shift) {
    VectorXd q = coordinates;
    q(i) += shift;
    return dimensionless_determinant(machine, q, length);
  };
  // The change over the whole reach on both sides: a root inside shows as a change of sign.
  std::optional<OnSurface> best;
  double steepest = 0;
  for (int i = 0; i < machine.dof(); ++i) {
    double low = -reach * unit(i), high = -low, at_low = det(i, low);
    const double at_high = det(i, high), slope = std::abs(at_high - at_low);
    if (!(at_low * at_high < 0) || !(slope > steepest)) continue;
    steepest = slope;
    for (int k = 0; k < 60 && high - low > 1e-17 * unit(i); ++k) {
      const double middle = 0.5 * (low + high), value = det(i, middle);
      if (value * at_low > 0)
        low = middle, at_low = value;
      else
        high = middle;
    }
    best = OnSurface{coordinates, i, 0.5 * (low + high)};
    best->coordinates(i) += best->moved;
  }
  return best;
}

}  // namespace pmreport::mechanics
