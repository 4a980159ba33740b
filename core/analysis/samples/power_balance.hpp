// Power against energy, along a whole motion.
#pragma once

#include <core/analysis/samples/motion_answers.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/load.hpp>

namespace pmreport::analysis {

// The power of actuators and load against the rate of the energy, which comes from positions and velocities along the motion around a
// sample: no acceleration and no force enters it. Differences never straddle a knot; a sample that lies on one, or close to it, is
// represented by the middle of the stretch that begins there. Where the energy is not smooth even so, differences tell nothing, and the
// sample is left out. `answers`: of all samples, with forces in motion; gets the residuals of some samples.
void balance_power(const mechanics::Trajectory& trajectory, const scenario::Load& load, const mechanics::Machine& machine,
                   MotionAnswers& answers);

}  // namespace pmreport::analysis
