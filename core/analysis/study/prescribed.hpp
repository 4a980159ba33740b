// A motion by actuators: whether they move as the scenario prescribes.
#pragma once

#include <core/analysis/analysis.hpp>

namespace pmreport::analysis {

// Largest deviation of the actuators, by inverse displacement of the coordinates found and by the jets along them, from what is prescribed;
// relative: of values to the mechanism's size, of rates and accelerations to the largest that the motion brings about, in sizes or radians
// a second. Next to a singular surface coordinates move much faster than the actuators, which then are small differences of large numbers.
struct PrescribedDeviation {
  double value = 0, rate = 0, acceleration = 0;
};
// The scenario's motion must prescribe the actuators.
PrescribedDeviation prescribed_deviation(const Analysis& a);

}  // namespace pmreport::analysis
