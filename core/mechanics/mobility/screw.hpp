// Screws: a twist or a wrench as an axis in space with a pitch.
#pragma once

#include <Eigen/Core>
#include <core/mechanics/model/state.hpp>
#include <vector>

namespace pmreport::mechanics {

// A line with a pitch: of a wrench the couple per unit of force along it, of a twist the translation along it per radian about it.
struct Screw {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();       // of the axis, nearest to the point that moments or velocities refer to [m]
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  // unit; it points up, else along Y, else along X
  double pitch = 0;                                      // [m], 0: a force, or a rotation; infinite: a couple, or a translation

  bool is_line() const { return pitch == 0; }
  bool is_free() const;                                        // of infinite pitch: it has a direction and no axis
  double distance(const Eigen::Vector3d& p) const;             // of p from the axis [m]
  bool passes(const Eigen::Vector3d& p, double length) const;  // within 1e-6 of the length
  bool parallel(const Eigen::Vector3d& unit_direction) const;  // within 1e-6
  bool same_axis(const Eigen::Vector3d& p, const Eigen::Vector3d& unit_direction, double length) const;
};

// Of the wrench (force; moment about `origin`): axis along f through origin + f x m / f^2, pitch f.m / f^2. Of magnitudes that differ by
// less than 1e-9, moments taken per `length` [m], the smaller counts as zero.
Screw screw_of_wrench(const Vector6d& wrench, const Eigen::Vector3d& origin, double length);

// Of the twist (velocity of `origin`; angular velocity): axis along w through origin + w x v / w^2, pitch w.v / w^2.
Screw screw_of_twist(const Vector6d& twist, const Eigen::Vector3d& origin, double length);

// Linear subspaces, each by the orthonormal columns of a matrix. A pivot counts as zero below `rank_tolerance` of the largest one, or of
// `size`: what a pivot of such a matrix is when it is not rounding. Parts of orthonormal columns have size 1, and may be zero altogether.
constexpr double rank_tolerance = 1e-9;  // far above rounding (1e-15), far below what tells a regular pose from a singular one
int rank(const Eigen::MatrixXd& m, double size = 0);
Eigen::MatrixXd null_space(const Eigen::MatrixXd& m, double size = 0);    // x with m x = 0
Eigen::MatrixXd column_space(const Eigen::MatrixXd& m, double size = 0);  // all m x

// Directions (unit vectors, or parts of such) that span the same plane, or line, or space, as few of their components filled as possible:
// base axes where they lie in it. 3 x d in and out; orthonormal, deterministic.
Eigen::MatrixXd aligned(const Eigen::MatrixXd& directions);

}  // namespace pmreport::mechanics
