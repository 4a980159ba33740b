// When the platform is where, for pictures of a whole motion.
#pragma once

#include <reports/scene/showing/overlay.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// A mark at each of these samples, which are in reach, and at round times between them, each where the platform is then, between samples
// along a straight line. Where it comes back to a place the times stand together; at that of a sample shown no round time does. Empty where
// the platform turns on the spot.
std::vector<scene::Mark> times_on_path(const Analysis& a, const std::vector<int>& shown);

}  // namespace pmreport::section
