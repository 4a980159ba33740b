// Whether what was recorded is what the plugin computes: at the poses of the motion itself.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>

namespace pmreport::analysis {

// What may be left: sums in another order, divisions by limb lengths and poses near the edge of the box cost a few digits.
constexpr double recording_rounding = 1e-10;

// The largest difference, at so many samples spread evenly over those with a pose, between the program's numbers and those of `place` and
// `jacobian`: of a number of the placement relative to the largest of it, of G to the largest of its row. Infinite where one has a number
// and the other has none. NaN: no sample was compared.
// The machine has a program.
double recording_deviation(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory, int samples = 64);

}  // namespace pmreport::analysis
