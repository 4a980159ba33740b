#include <core/mechanics/dynamics/drive.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

double drive_force(const DriveTrain& drive, double force, double rate) {
  const bool driven_back = drive.convention == EfficiencyConvention::by_power && force * rate < 0;
  return driven_back ? force * drive.efficiency : force / drive.efficiency;
}

MotorState motor(const DriveTrain& drive, double force, double rate, double acceleration) {
  return {drive_force(drive, force, rate) / drive.ratio + drive.inertia * drive.ratio * acceleration, drive.ratio * rate};
}

bool MotionLimits::any() const {
  for (const auto* list : {&force, &speed, &power, &joint_force, &joint_moment})
    if (std::any_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); })) return true;
  return false;
}

}  // namespace pmreport::mechanics
