#include <core/mechanics/stiffness/answers.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/linear/singular_values.hpp>
#include <core/linear/square.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// Least over largest singular value of a compliance, moments per length, below which a direction does not give.
constexpr double rigid_share = 1e-12;

// Moments m = m' length: with S = diag(1, 1, 1, length ...) wrenches w = S w', and S C S is in [m/N] throughout.
Vector6d per_length(double length) { return (Vector6d() << 1, 1, 1, Vector3d::Constant(1 / length)).finished(); }

struct Directions {
  Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 6> wrenches;  // of unit strain energy (a^T C a = 1), in true units
};
Directions directions_of(const Matrix6d& compliance, double length) {
  const Vector6d s = per_length(length);
  const linear::SymmetricEigen6 parts = linear::symmetric_eigen(Matrix6d(s.asDiagonal() * compliance * s.asDiagonal()));
  Directions out;
  const double least = rigid_share * parts.values(5);
  Index first = 0;
  while (first < 6 && !(parts.values(first) > least)) ++first;
  out.wrenches = s.asDiagonal() * parts.vectors.rightCols(6 - first);
  for (Index i = first; i < 6; ++i) out.wrenches.col(i - first) /= std::sqrt(parts.values(i));
  return out;
}

}  // namespace

Matrix6d to_tool(const Vector3d& r, const Matrix3d& axes) {
  Matrix6d t = Matrix6d::Zero();
  t.topLeftCorner<3, 3>() = axes;
  t.bottomRightCorner<3, 3>() = axes;
  for (int k = 0; k < 3; ++k) t.block<3, 1>(3, k) = r.cross(Vector3d(axes.col(k)));
  return t;
}

DeformationIndices deformation_indices(const Matrix6d& c) {
  const Vector3d pF = linear::singular_values(Matrix3d(c.topLeftCorner<3, 3>())),
                 pT = linear::singular_values(Matrix3d(c.topRightCorner<3, 3>())),
                 PhiT = linear::singular_values(Matrix3d(c.bottomRightCorner<3, 3>()));
  return {pF(0), pF(2), pT(0), pT(2), PhiT(0), PhiT(2)};
}

int rank_of(const Matrix6d& compliance, double length) { return static_cast<int>(directions_of(compliance, length).wrenches.cols()); }

std::optional<Matrix6d> stiffness_of(const Matrix6d& compliance, double length) {
  const Directions all = directions_of(compliance, length);
  if (all.wrenches.cols() < 6) return std::nullopt;
  return Matrix6d(all.wrenches * all.wrenches.transpose());  // C = A^-T A^-1 for A^T C A = 1
}

std::array<Eigenscrew, 6> eigenscrews(const Matrix6d& stiffness) {
  const Matrix6d l = stiffness.llt().matrixL();
  Matrix6d swapped;
  swapped << l.bottomRows<3>(), l.topRows<3>();
  const Matrix6d form = l.transpose() * swapped;
  const linear::SymmetricEigen6 parts = linear::symmetric_eigen(Matrix6d(0.5 * (form + form.transpose())));
  const Matrix6d twists = l.transpose().triangularView<Eigen::Upper>().solve(parts.vectors);
  std::array<Eigenscrew, 6> out;
  for (Index i = 0; i < 6; ++i) {
    Vector3d v = twists.col(i).head<3>(), w = twists.col(i).tail<3>();
    Index largest = 0;
    w.cwiseAbs().maxCoeff(&largest);
    const double scale = (w(largest) < 0 ? -1 : 1) / w.norm();
    v *= scale, w *= scale;
    out[static_cast<std::size_t>(i)] = {parts.values(i), w.dot(v), w, w.cross(v)};
  }
  return out;
}

// In wrenches of unit strain energy, A^T C A = 1, and with B = A^T M A the motion a = A b cos(omega t) has b . b = omega^2 b . B b.
std::vector<Mode> modes(const Matrix6d& compliance, const Matrix6d& inertia, double length) {
  const Directions all = directions_of(compliance, length);
  const Index n = all.wrenches.cols();
  std::vector<Mode> out;
  if (n == 0) return out;
  Eigen::MatrixXd reduced = all.wrenches.transpose() * inertia * all.wrenches;
  reduced = (0.5 * (reduced + reduced.transpose())).eval();
  VectorXd values;
  Eigen::MatrixXd vectors;
  if (n == 6) {
    const linear::SymmetricEigen6 parts = linear::symmetric_eigen(Matrix6d(reduced));
    values = parts.values, vectors = parts.vectors;
  } else {
    const linear::SymmetricEigen parts = linear::symmetric_eigen(reduced);
    values = parts.values, vectors = parts.vectors;
  }
  for (Index i = n; i-- > 0;) {
    if (!(values(i) > rigid_share * values(n - 1))) break;  // a direction without inertia
    const Vector6d shape = compliance * (all.wrenches * vectors.col(i)) / std::sqrt(values(i));
    out.push_back({1 / (2 * std::numbers::pi * std::sqrt(values(i))), shape});
  }
  return out;
}

// A y = y / omega^2; the masses load the machine with omega^2 y, and the platform moves by omega^2 D y, D its displacements by each mass.
std::vector<WholeMode> whole_modes(const ElasticPose& pose, int most, bool shapes) {
  std::vector<WholeMode> out;
  const Index n = pose.flexibility.rows();
  if (n == 0) return out;
  linear::SymmetricEigen parts;
  if (shapes)
    parts = linear::symmetric_eigen(pose.flexibility);
  else
    parts.values = linear::symmetric_eigenvalues_of(pose.flexibility);
  for (Index i = n; i-- > 0 && static_cast<int>(out.size()) < most;) {
    if (!(parts.values(i) > rigid_share * parts.values(n - 1))) break;  // held rigidly
    WholeMode mode;
    mode.frequency = 1 / (2 * std::numbers::pi * std::sqrt(parts.values(i)));
    mode.shape.setZero();
    if (shapes) {
      mode.masses = parts.vectors.col(i);
      mode.shape = pose.by_mass * mode.masses / parts.values(i);
    }
    out.push_back(std::move(mode));
  }
  return out;
}

std::vector<double> shares(const ElasticPose& pose, std::size_t elements, const Vector6d& along, const VectorXd& forces, bool strained) {
  std::vector<double> out(elements + 1, 0.0);
  const VectorXd q = pose.unit * along;
  for (std::size_t i = 0; i < pose.parts.springs.size(); ++i) {
    const Spring& s = pose.parts.springs[i];
    const auto at = static_cast<Index>(i);
    const std::size_t element = s.element < 0 ? elements : static_cast<std::size_t>(s.element);
    out[element] += q(at) * (s.compliance * forces(at) + (strained ? s.shortens : 0.0));
  }
  return out;
}

// Moments at both ends of a stretch follow from that at its middle and the force across: a force along x bends about y.
std::vector<BeamForces> beam_forces(const ElasticPose& pose, std::size_t elements, const VectorXd& forces) {
  std::vector<BeamForces> out(elements);
  for (const BeamStretch& s : pose.parts.stretches) {
    BeamForces& b = out[static_cast<std::size_t>(s.element)];
    const auto q = [&](int k) { return forces(s.first + k); };
    if (std::abs(q(0)) > std::abs(b.axial)) b.axial = -q(0);
    b.compression = std::max(b.compression, q(0));
    b.torque = std::max(b.torque, std::abs(q(3)));
    for (const double end : {-0.5 * s.length, 0.5 * s.length})
      b.bending = std::max(b.bending, std::hypot(q(4) + end * q(2), q(5) - end * q(1)));
  }
  return out;
}

double buckling_load(const Element& beam, double length) {
  const double least = beam.material.modulus * std::min(beam.section.bending[0], beam.section.bending[1]);
  if (beam.buckling_length == 0) return std::numeric_limits<double>::infinity();
  const double k = std::numbers::pi / (beam.buckling_length * length);
  return k * k * least;
}

}  // namespace pmreport::mechanics
