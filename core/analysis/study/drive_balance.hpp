// What enters and leaves the drives along a motion.
#pragma once

#include <core/analysis/analysis.hpp>

#include <limits>

namespace pmreport::analysis {

bool has_motor(const Analysis& a, std::size_t actuator);

// Share of the samples at which the actuator is driven back: force and rate oppose each other. NaN where no sample has forces.
double driven_back(const Analysis& a, const Actuator& actuator);

struct DriveBalance {
  // Largest power that a drive gives beyond what it takes, relative to the largest that any takes; NaN where the convention of the source
  // allows it.
  double gained = std::numeric_limits<double>::quiet_NaN();
  // Largest deviation of what motors give beyond what the drives take from the rate of the energy of rotor and screw, by differences;
  // relative to the largest motor power. NaN where nothing is compared.
  double left_over = std::numeric_limits<double>::quiet_NaN();
};
DriveBalance drive_balance(const Analysis& a);

}  // namespace pmreport::analysis
