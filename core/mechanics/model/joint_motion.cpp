#include <core/mechanics/model/joint_motion.hpp>

#include <numbers>

namespace pmreport::mechanics {

bool binds(const Joint& joint, const Range& range, bool upper) {
  constexpr double rounding = 1e-12, free = 10;  // [m]
  if (joint.kind == JointKind::prismatic) return upper ? range.max < free : range.min > -free;
  if (range.max - range.min >= 2 * std::numbers::pi * (1 - rounding)) return false;
  return upper || joint.kind != JointKind::spherical || range.min > 0;
}

bool is_told(const Joint& joint, std::size_t k) {
  return joint.kind != JointKind::prismatic || binds(joint, joint.limits[k], false) || binds(joint, joint.limits[k], true);
}

const char* motion_unit(const Joint& joint) { return joint.kind == JointKind::prismatic ? "m" : "rad"; }

}  // namespace pmreport::mechanics
