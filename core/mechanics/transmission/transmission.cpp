#include <core/mechanics/transmission/transmission.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/linear/scaled_inverse.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::Vector3d;

namespace {

double cosine(const Vector3d& force, const Vector3d& velocity) {
  const double sizes = force.norm() * velocity.norm();
  return sizes > 0 ? std::min(std::abs(force.dot(velocity)) / sizes, 1.0) : 0;
}

// Columns of the inverse of a square matrix up to a factor each: column i of the inverse is columns.col(i) * rows(i) / pivot. Rows are made
// unit first, so that pivots compare.
struct Directions {
  linear::SmallMatrix columns;
  linear::SmallVector rows;  // one over the length of each row
  double pivot = 0;          // the least: 0 where there is no inverse, of the order of 1 where rows are far apart
  double factor(Index i) const { return rows(i) / pivot; }  // infinite where there is no inverse
};
Directions directions(const linear::SmallMatrix& a) {
  const Index n = a.rows();
  linear::SmallMatrix unit = a;
  linear::SmallVector rows(n);
  for (Index i = 0; i < n; ++i) {
    const double size = unit.row(i).norm();
    rows(i) = size > 0 ? 1 / size : 1;
    unit.row(i) *= rows(i);
  }
  linear::ScaledInverse inverse = linear::scaled_inverse(unit);
  return {std::move(inverse.columns), std::move(rows), inverse.scale};
}

double largest_singular_value(const linear::SmallMatrix& m) {
  return std::sqrt(linear::symmetric_eigenvalues(linear::SmallMatrix(m.transpose() * m)).tail<1>()(0));
}

// Of the first `size` rows and columns of G^, with the directions of all of it. The least singular value is one over the largest of the
// inverse, and both come from eigenvalues that are the largest of their matrices, which lose no digits to squares.
void put_conditioning(const Matrix6d& made, const Directions& d, Index size, TransmissionIndices& out) {
  const linear::SmallMatrix block = made.topLeftCorner(size, size),
                            inverse = d.columns.topLeftCorner(size, size) * d.rows.head(size).asDiagonal();
  const double most = largest_singular_value(block), of_inverse = largest_singular_value(inverse);
  const double least = of_inverse > 0 ? std::abs(d.pivot) / of_inverse : 0;
  out.condition = least > 0 ? most / least : std::numeric_limits<double>::infinity();
  out.conditioning = most > 0 ? least / most : 0;
  out.manipulability = 1 / std::abs(linear::SmallFactors(block).determinant());
}

// Of a column of zeros there is no rate at all, however large the factor.
template <class Column>
auto by_unit_rate(const Column& column, double factor) {
  return (column.isZero(0) ? column * 0 : column * factor).eval();
}

}  // namespace

Transmission::Transmission(const Machine& machine, double length)
    : machine_(machine),
      length_(length > 0 ? length : characteristic_length(machine)),
      paths_(transmission_paths(machine, characteristic_length(machine))) {
  const Topology& t = machine.topology();
  for (int i = 0; i < machine.dof(); ++i) {
    Ends& ends = ends_.emplace_back();
    const auto& telescope = drive(i).telescope;
    by_motions_ = by_motions_ || telescope || (drive(i).entry.exists() && drive(i).entry.body != t.platform);
    if (!telescope) continue;
    const Joint& slide = t.joints[static_cast<std::size_t>(t.actuators[static_cast<std::size_t>(i)].joint)];
    const auto outside = [&](int joint) {
      const Joint& j = t.joints[static_cast<std::size_t>(joint)];
      return j.a == slide.a || j.a == slide.b ? j.b : j.a;
    };
    ends = {outside(telescope->near), outside(telescope->far)};
  }
}

bool Transmission::has_local() const {
  return std::ranges::all_of(paths_.drives, [](const DrivePath& d) { return d.no_output.empty(); });
}
bool Transmission::has_pressure() const {
  return std::ranges::all_of(paths_.drives, [](const DrivePath& d) { return d.no_pressure.empty(); });
}

std::optional<TransmissionIndices> Transmission::at(std::span<const double> coordinates) const {
  Work work;
  TransmissionIndices out;
  return at(coordinates, work, out) ? std::optional(out) : std::nullopt;
}

bool Transmission::at(std::span<const double> coordinates, Work& work, TransmissionIndices& out) const {
  const Layout& layout = machine_.layout();
  const auto components = static_cast<std::size_t>(1 + machine_.dof());
  work.partials.resize(layout.size() * components);
  if (machine_.place(PM_PARTIALS, 1, coordinates.data(), work.partials.data()) != PM_OK) return false;
  work.placement.resize(layout.size());
  for (std::size_t s = 0; s < layout.size(); ++s) work.placement[s] = work.partials[s * components];
  const Jacobian jacobian = machine_.jacobian(work.placement.data());
  if (!jacobian.known()) return false;

  const Matrix6d made = dimensionless(machine_, jacobian.matrix, length_);
  const Directions d = directions(made);
  Matrix6d twists = d.columns;
  twists.bottomRows<3>() /= length_;
  Vector6d factors;
  for (Index i = 0; i < 6; ++i) factors(i) = d.factor(i);
  for (Index i = 0; i < machine_.dof(); ++i)
    if (machine_.topology().actuators[static_cast<std::size_t>(i)].sense() == Sense::rotary) factors(i) *= length_;
  of_rows(jacobian.matrix, twists, factors, work, out);
  if (by_motions_) by_motions(coordinates, work, out);
  put_conditioning(made, d, paths_.translates ? 3 : 6, out);
  return true;
}

// (1) of drives that are none along a line, (2) to (4).
void Transmission::of_rows(const Matrix6d& g, const Matrix6d& twists, const Vector6d& factors, const Work& work,
                           TransmissionIndices& out) const {
  const Topology& t = machine_.topology();
  const Layout& layout = machine_.layout();
  const auto three = [&](std::size_t first) { return Eigen::Map<const Vector3d>(&work.placement[first]); };
  const Vector3d origin = three(layout.body(t.platform));
  const auto lever = [&](const BodyPoint& point) {  // from the reference point
    Vector3d sum = Vector3d::Zero();
    for (const int j : point.joints) sum += three(layout.joint(j)) - origin;
    return Vector3d(point.joints.empty() ? sum : sum / static_cast<double>(point.joints.size()));
  };
  const auto velocity = [&](int i, const BodyPoint& point) {
    return Vector3d(twists.col(i).head<3>() + twists.col(i).tail<3>().cross(lever(point)));
  };

  out.local = 1;
  for (int i = 0; i < machine_.dof(); ++i) {
    const DrivePath& path = drive(i);
    TransmissionIndices::OfActuator& to = out.actuators[static_cast<std::size_t>(i)];
    const Vector3d force = g.row(i).head<3>();
    to.twist = by_unit_rate(twists.col(i), factors(i));
    if (!path.telescope) {
      to.force = path.no_pressure.empty() ? Vector3d(force.normalized()) : Vector3d::Constant(nan);
      to.velocity.setConstant(nan), to.cosine = nan;
      if (path.no_pressure.empty() && path.entry.body == t.platform) {
        const Vector3d v = velocity(i, path.entry);
        to.velocity = by_unit_rate(v, factors(i)), to.cosine = cosine(to.force, v);
      }
    }
    to.output = to.input = nan;
    if (path.no_output.empty()) {
      to.output = cosine(force, velocity(i, path.output));
      to.input = cosine(force, input_direction(i, work));
    }
    out.local = std::isnan(to.output) || std::isnan(out.local) ? nan : std::min({out.local, to.output, to.input});
  }
  for (int i = machine_.dof(); i < 6; ++i) {
    const ConstraintPath& path = paths_.constraints[static_cast<std::size_t>(i - machine_.dof())];
    double& to = out.constraints[static_cast<std::size_t>(i - machine_.dof())];
    to = !path.none.empty() ? nan
         : path.couple      ? cosine(g.row(i).tail<3>(), twists.col(i).tail<3>())
                            : cosine(g.row(i).head<3>(), velocity(i, path.point));
  }
}

// The way the drive moves what it moves: of a slide its axis; of a motor across its axis and the arm to the next joint.
Vector3d Transmission::input_direction(int actuator, const Work& work) const {
  const Topology& t = machine_.topology();
  const Layout& layout = machine_.layout();
  const int joint = t.actuators[static_cast<std::size_t>(actuator)].joint;
  const auto three = [&](std::size_t first) { return Vector3d(Eigen::Map<const Vector3d>(&work.placement[first])); };
  const Vector3d centre = three(layout.joint(joint)), axis = three(layout.joint(joint) + 3);
  if (t.joints[static_cast<std::size_t>(joint)].kind == JointKind::prismatic) return axis;
  Vector3d arm = Vector3d::Zero();
  for (const int j : drive(actuator).next) arm += three(layout.joint(j)) - centre;
  return axis.cross(arm);
}

// The ends of telescopic drives, and points of bodies of the platform, move with the coordinates: with A = dr/dq, r the actuators, column i
// of A^-1 goes with output twist i. Where the coordinates are a poor chart A is singular although the machine is not, and a basis of
// motions that asks for no coordinate takes their place.
void Transmission::by_motions(std::span<const double> coordinates, Work& work, TransmissionIndices& out) const {
  const Topology& t = machine_.topology();
  const Layout& layout = machine_.layout();
  const auto dof = static_cast<Index>(machine_.dof());
  const auto components = static_cast<std::size_t>(1 + dof);
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, 6>;
  const auto partials = [&](std::size_t scalar) { return Eigen::Map<const Row>(&work.partials[scalar * components + 1], dof); };

  linear::SmallMatrix a(dof, dof);
  linear::SmallVector columns(dof);
  for (Index i = 0; i < dof; ++i) {
    a.row(i) = partials(layout.actuator(static_cast<int>(i)));
    columns(i) = t.coordinates[static_cast<std::size_t>(i)].sense() == Sense::rotary ? 1 / length_ : 1;
  }
  Directions motions = directions(a * columns.asDiagonal());
  const bool by_tangent = std::abs(motions.pivot) < poor_chart;
  if (by_tangent) {
    const linear::SmallVector still = linear::SmallVector::Zero(dof);
    evaluate(machine_, coordinates.data(), still.data(), still.data(), work.state);
    if (work.state.status != PM_OK) return;
    tangent(machine_, work.state, work.tangent);
    if (!work.tangent.by_coordinates) columns.setOnes();
    motions = directions(work.tangent.actuators * columns.asDiagonal());
  }
  motions.columns = (columns.asDiagonal() * motions.columns).eval();
  // Of the centre of a joint, as `body` carries it.
  const auto velocity = [&](Index motion, int joint, int body) -> Vector3d {
    const auto column = motions.columns.col(motion);
    const std::size_t at = layout.joint(joint);
    if (!by_tangent) return {partials(at).dot(column), partials(at + 1).dot(column), partials(at + 2).dot(column)};
    if (body == 0) return Vector3d::Zero();
    const Vector6d twist = work.tangent.bodies.middleRows<6>(6 * static_cast<Index>(body) - 6) * column;
    const Vector3d from_origin = Eigen::Map<const Vector3d>(&work.placement[at]) - work.state.bodies[static_cast<std::size_t>(body)].origin;
    return twist.head<3>() + twist.tail<3>().cross(from_origin);
  };
  for (Index i = 0; i < dof; ++i) {
    const DrivePath& path = drive(static_cast<int>(i));
    TransmissionIndices::OfActuator& to = out.actuators[static_cast<std::size_t>(i)];
    Vector3d v = Vector3d::Zero();
    if (path.telescope) {
      const Ends& ends = ends_[static_cast<std::size_t>(i)];
      v = velocity(i, path.telescope->far, ends.far) - velocity(i, path.telescope->near, ends.near);
      const int slide = t.actuators[static_cast<std::size_t>(i)].joint;
      to.force = Eigen::Map<const Vector3d>(&work.placement[layout.joint(slide) + 3]);
    } else if (path.no_pressure.empty() && path.entry.body != t.platform) {
      for (const int j : path.entry.joints) v += velocity(i, j, path.entry.body) / static_cast<double>(path.entry.joints.size());
    } else {
      continue;
    }
    to.velocity = by_unit_rate(v, motions.factor(i)), to.cosine = cosine(to.force, v);
  }
}

}  // namespace pmreport::mechanics
