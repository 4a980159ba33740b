// Prescribed actuators: where the coordinates that follow them are at every instant, and not at samples alone, proved by interval Newton
// along the path that was followed numerically (moving_frame and krawczyk beside this file tell the mathematics).
//
// The motion is covered by a chain of spans of time. For each a box of coordinates that moves with the path is found in which, at every
// instant of the span, exactly one pose has the prescribed actuators. Spans that meet are linked: the pose that the one proves at the
// instant that they share lies where the other's is the only one. So the chain is one motion without a jump, from the pose at the
// beginning; and the numerical path lies in the chain's boxes at each of its samples. Any span is then answered within these boxes.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/program/intervals/bounds.hpp>

#include <string>

namespace pmreport::analysis {

using program::Bounds;

struct FollowedOptions {
  int most_spans = 20000;   // that are tried
  double finest = 1e-7;     // [s]: no span is halved that is shorter
  double agreement = 1e-6;  // how near the path must be to the motion, in characteristic lengths, or radians
};

struct FollowedProof {
  // The coordinates over spans of time within `proved`; none where nothing is. Safe in threads; needs only `actuators` to live.
  mechanics::Enclosure over;
  Bounds proved;       // [s]: from the first sample on; a single instant, or none of it, where `over` is none
  std::string reason;  // from when on the motion is not proved, and why; empty: all of it is
  int spans = 0;       // of the chain
};

// `actuators`: their bounds over spans of time, continuous but for the breaks of the trajectory. `trajectory`: the path that was followed.
FollowedProof prove_followed(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory,
                             const mechanics::Enclosure& actuators, const FollowedOptions& options = {});

}  // namespace pmreport::analysis
