// Screws: a twist or a wrench as an axis in space with a pitch.
#pragma once

#include <core/linear/types.hpp>

namespace pmreport::mechanics {

using linear::Vector6d;

// A wrench (f; m), m about O, is a force along a line through A and a couple about it, h the couple per force,
//     m = p_OA x f + h f,   hence with A nearest to O   p_OA = f x m / f^2,   h = f . m / f^2              (1)
// as f x (p_OA x f) = f^2 p_OA where p_OA is across f. Of a twist (v; w), v the velocity of O, the same holds with w for f and v for m,
//     v = p_OA x w + h w                                                                                 (2)
// for a turn about a line through A moves O by w x p_AO = p_OA x w.

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

// By (1), of the wrench (force; moment about `origin`) [N], [N m]. Of force, and moment per `length` [m], the one that is less than 1e-9 of
// the other counts as zero: a couple, or a pure force.
Screw screw_of_wrench(const Vector6d& wrench, const Eigen::Vector3d& origin, double length);

// By (2), of the twist (velocity of `origin`; angular velocity), likewise.
Screw screw_of_twist(const Vector6d& twist, const Eigen::Vector3d& origin, double length);

// Directions (unit vectors, or parts of such) that span the same plane, or line, or space, as few of their components filled as possible:
// base axes where they lie in it. 3 x d in and out; orthonormal, deterministic.
Eigen::MatrixXd aligned(const Eigen::MatrixXd& directions);

}  // namespace pmreport::mechanics
