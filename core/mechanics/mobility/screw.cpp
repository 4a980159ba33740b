#include <core/mechanics/mobility/screw.hpp>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

constexpr double negligible = 1e-9;  // of two magnitudes, the smaller one
constexpr double coincident = 1e-6;  // geometry of a machine that was solved for in double precision is met a thousand times better

Vector3d upward(const Vector3d& d) {
  for (const int k : {2, 1, 0})
    if (std::abs(d(k)) > coincident) return d(k) > 0 ? d : Vector3d(-d);
  return d;
}

// `along` has the direction of the axis, `about` is what it adds at the origin: force and moment, or angular velocity and velocity. With
// about = (point - origin) x along + pitch along, crossing with `along` gives the point, the product with it the pitch.
Screw screw_of(const Vector3d& along, const Vector3d& about, const Vector3d& origin, double length) {
  const double axial = along.norm() * length, polar = about.norm();
  if (axial <= negligible * polar) return {origin, upward(about.normalized()), std::numeric_limits<double>::infinity()};
  Screw s{origin + along.cross(about) / along.squaredNorm(), upward(along.normalized()), along.dot(about) / along.squaredNorm()};
  if (std::abs(s.pitch) <= negligible * (length + polar / along.norm())) s.pitch = 0;
  return s;
}

struct Factors {
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  Eigen::Index rank = 0;
};
Factors factorised(const MatrixXd& m, double size) {
  Factors f{Eigen::ColPivHouseholderQR<MatrixXd>(m)};
  const double least = rank_tolerance * std::max(size, f.qr.maxPivot());
  for (Eigen::Index k = 0; k < std::min(m.rows(), m.cols()); ++k) f.rank += std::abs(f.qr.matrixQR()(k, k)) > least ? 1 : 0;
  return f;
}

}  // namespace

bool Screw::is_free() const { return std::isinf(pitch); }
double Screw::distance(const Vector3d& p) const { return direction.cross(p - point).norm(); }
bool Screw::passes(const Vector3d& p, double length) const { return !is_free() && distance(p) <= coincident * length; }
bool Screw::parallel(const Vector3d& unit_direction) const { return direction.cross(unit_direction).norm() <= coincident; }
bool Screw::same_axis(const Vector3d& p, const Vector3d& unit_direction, double length) const {
  return passes(p, length) && parallel(unit_direction);
}

Screw screw_of_wrench(const Vector6d& wrench, const Vector3d& origin, double length) {
  return screw_of(wrench.head<3>(), wrench.tail<3>(), origin, length);
}
Screw screw_of_twist(const Vector6d& twist, const Vector3d& origin, double length) {
  return screw_of(twist.tail<3>(), twist.head<3>(), origin, length);
}

int rank(const MatrixXd& m, double size) { return m.size() == 0 ? 0 : static_cast<int>(factorised(m, size).rank); }

MatrixXd null_space(const MatrixXd& m, double size) {
  const Eigen::Index n = m.cols();
  if (m.rows() == 0 || n == 0) return MatrixXd::Identity(n, n);
  const Factors f = factorised(m.transpose(), size);
  return MatrixXd(f.qr.householderQ() * MatrixXd::Identity(n, n)).rightCols(n - f.rank);
}

MatrixXd column_space(const MatrixXd& m, double size) {
  if (m.size() == 0) return MatrixXd(m.rows(), 0);
  const Factors f = factorised(m, size);
  return MatrixXd(f.qr.householderQ() * MatrixXd::Identity(m.rows(), m.rows())).leftCols(f.rank);
}

// Gauss-Jordan with the pivots in the order x y z makes the rows sparse; Gram-Schmidt then keeps base axes that are among them.
MatrixXd aligned(const MatrixXd& directions) {
  MatrixXd rows = column_space(directions, 1).transpose();
  Eigen::Index next = 0;
  for (Eigen::Index c = 0; c < 3 && next < rows.rows(); ++c) {
    Eigen::Index pivot;
    if (rows.col(c).tail(rows.rows() - next).cwiseAbs().maxCoeff(&pivot) < coincident) continue;
    rows.row(next).swap(rows.row(next + pivot));
    rows.row(next) /= rows(next, c);
    for (Eigen::Index r = 0; r < rows.rows(); ++r)
      if (r != next) rows.row(r) -= rows(r, c) * rows.row(next);
    ++next;
  }
  // The sparsest first, so that what is a base axis stays one.
  std::vector<Vector3d> all;
  for (int most = 1; most <= 3; ++most)
    for (Eigen::Index r = 0; r < rows.rows(); ++r)
      if ((rows.row(r).cwiseAbs().array() > coincident).count() == most) all.push_back(rows.row(r).transpose());
  MatrixXd out(3, static_cast<Eigen::Index>(all.size()));
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(k);
    Vector3d d = all[k];
    for (Eigen::Index j = 0; j < at; ++j) d -= out.col(j).dot(d) * out.col(j);
    out.col(at) = upward(d.normalized());
  }
  return out;
}

}  // namespace pmreport::mechanics
