// The trajectory of coordinates that follow prescribed actuators.
#pragma once

#include <core/mechanics/displacement/follow.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>

namespace pmreport::mechanics {

struct Followed {
  Trajectory trajectory;            // all times; without a pose from the obstacle on
  std::size_t reached = 0;          // samples with a pose
  Outcome outcome = Outcome::good;  // what ends it
};

// By forward displacement from `start`, where the actuators have their values of the first time (follow.hpp). Between samples the
// coordinates are followed from the nearest one. `machine` must outlive the trajectory.
Followed followed(const Machine& machine, Path actuators, std::vector<double> times, const SmallVector& start);

}  // namespace pmreport::mechanics
