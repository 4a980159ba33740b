#include <core/mechanics/mobility/screw.hpp>

#include <core/linear/subspace.hpp>

#include <Eigen/Geometry>
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

// (1) and (2): `along` is f or w, `about` is m or v.
Screw screw_of(const Vector3d& along, const Vector3d& about, const Vector3d& origin, double length) {
  const double axial = along.norm() * length, polar = about.norm();
  if (axial <= negligible * polar) return {origin, upward(about.normalized()), std::numeric_limits<double>::infinity()};
  Screw s{origin + along.cross(about) / along.squaredNorm(), upward(along.normalized()), along.dot(about) / along.squaredNorm()};
  if (std::abs(s.pitch) <= negligible * (length + polar / along.norm())) s.pitch = 0;
  return s;
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

// Gauss-Jordan with the pivots in the order x y z makes the rows sparse; Gram-Schmidt then keeps base axes that are among them.
MatrixXd aligned(const MatrixXd& directions) {
  MatrixXd rows = linear::column_space(directions, 1).transpose();
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
