// Where a trajectory meets the first singular surface, as seen by the side of it that its samples are on (overall_jacobian.hpp).
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>

#include <optional>

namespace pmreport::mechanics {

constexpr double resolution_of_span = 1e-10;  // of the whole motion: how exactly the time of an ending is found

struct FirstSurface {
  std::size_t before;  // samples before it
  double time;         // [s]; the last found on the side of the samples before, to the resolution above
};
// Nothing where the motion stays on one side. A sample on the surface itself is beyond; one without a pose is none to compare with.
std::optional<FirstSurface> first_singular_surface(const Trajectory& trajectory, const Machine& machine);

// Ends a trajectory of prescribed coordinates there, and says so in its `ending`; the samples stay. Returns how many are before it: all,
// where it meets none.
std::size_t end_at_singular_surface(Trajectory& trajectory, const Machine& machine);

}  // namespace pmreport::mechanics
