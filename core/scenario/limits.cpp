// [limits]: what actuators and joints may be asked for.
#include <core/scenario/parts.hpp>

namespace pmreport::scenario {

mechanics::MotionLimits read_limits(const Entry* entry, const MechanismPart& mechanism, const Reader& reader) {
  mechanics::MotionLimits limits;
  if (!mechanism.topology) return limits;
  const std::size_t actuators = mechanism.topology->actuators.size(), joints = mechanism.topology->joints.size();
  for (auto* list : {&limits.force, &limits.speed, &limits.power}) list->assign(actuators, mechanics::MotionLimits::none);
  for (auto* list : {&limits.joint_force, &limits.joint_moment}) list->assign(joints, mechanics::MotionLimits::none);
  if (const Value* content = table_of(entry, "limits", reader)) TableReader(*content, "[limits]", entry->place, reader).finish();
  return limits;
}

}  // namespace pmreport::scenario
