// From the motion that was asked for to the trajectory that was solved. What does not come about is told where it was asked for.
#pragma once

#include <core/scenario/load.hpp>
#include <core/scenario/motion/forces.hpp>
#include <core/scenario/motion/laws.hpp>
#include <optional>
#include <vector>

namespace pmreport::scenario {

// At these times. Nothing, told, where a law has no finite value, rate or acceleration.
std::optional<mechanics::Trajectory> sampled(const Laws& laws, const MotionRequest& request, std::vector<double> times,
                                             Diagnostics& diagnostics);
// Of coordinates that were sampled, ended at the first singular surface. Nothing, told, when too few samples remain.
std::optional<mechanics::Trajectory> end_at_singularity(mechanics::Trajectory trajectory, const mechanics::Machine& machine, Place place,
                                                        Diagnostics& diagnostics);
// The coordinates that follow the actuators, which were sampled; `place` is where these stand. Nothing, told, when there is no pose to
// start from, or, cut off at a singular surface, too few samples.
std::optional<mechanics::Trajectory> followed(const MotionRequest& request, const mechanics::Trajectory& actuators,
                                              const mechanics::Machine& machine, Place place, Diagnostics& diagnostics);
// The motion that follows from forces. Nothing, told, when it cannot begin, or, cut off, has too few samples.
std::optional<mechanics::Trajectory> forced(const Forces& forces, const MotionRequest& request, const Load& load, std::vector<double> times,
                                            const mechanics::Machine& machine, Diagnostics& diagnostics);

}  // namespace pmreport::scenario
