// The geometry that a mechanism records must be the one that it computes.
#pragma once

#include <core/mechanics/conformance/property_list.hpp>

#include <vector>

namespace pmreport::mechanics {

// The recording, and its derivatives, against place and jacobian at these poses, their coordinates one after another: all of them on plain
// numbers, the first few with rates, accelerations and partials. What cannot be recorded fails, unless the mechanism does not offer to.
void look_at_recording(const Machine& machine, const std::vector<double>& poses, PropertyList& p);

}  // namespace pmreport::mechanics
