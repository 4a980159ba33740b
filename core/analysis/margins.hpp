// How far the motion stays from what the wrenches on the platform do not tell: bodies that come loose with all actuators locked, freedoms
// that no actuator has a say in, limbs that lose their actuator, the end of reach; and from coordinates that are singular themselves.
#pragma once

#include <core/analysis/crossings.hpp>
#include <core/mechanics/model/tangent.hpp>
#include <core/mechanics/singularity/body_freedoms.hpp>
#include <core/mechanics/singularity/end_of_reach.hpp>

#include <optional>
#include <vector>

namespace pmreport::analysis {

struct Margins {
  std::vector<mechanics::BodyFreedoms::Margins> at_sample;  // NaN without a pose
  mechanics::BodyFreedoms::Margins sound{};  // what a sound pose has: that at home, or, where home has none, the most on the way
  bool home_is_singular = false;             // to rounding, by the wrenches on the platform
  std::vector<Crossing> losses;              // where one vanishes, at a sample or between samples

  struct Nearest {  // to the end of reach
    mechanics::EndOfReach end;
    int sample = 0;
  };
  std::optional<Nearest> end_of_reach;
  struct Chart {  // worst
    mechanics::ChartFault fault;
    int sample = 0, samples = 0;  // how many have one
  };
  std::optional<Chart> chart;
};

// Of all samples. `length`: characteristic_length(machine) [m].
Margins follow_margins(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine, double length);

}  // namespace pmreport::analysis
