#include <core/mechanics/model/joint_motion.hpp>

#include <numbers>

namespace pmreport::mechanics {

bool binds(const Joint& joint, const Range& range, bool upper) {
  constexpr double rounding = 1e-12;
  if (joint.kind == JointKind::prismatic) return false;
  if (range.max - range.min >= 2 * std::numbers::pi * (1 - rounding)) return false;
  return upper || joint.kind != JointKind::spherical || range.min > 0;
}

bool bounds_travel(const Joint& joint, const Range& range) {
  constexpr double free = 10;  // [m]
  return joint.kind == JointKind::prismatic && (range.min > -free || range.max < free);
}

}  // namespace pmreport::mechanics
