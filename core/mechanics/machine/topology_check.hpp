// Whether a declared topology makes sense.
#pragma once

#include <pmreport/topology.hpp>

namespace pmreport::mechanics {

// Indices in range, ranges in order, counts that fit: a plugin's slip is told by name instead of showing later as a wrong number. Throws
// MechanismError (PM_FAILED) with a sentence.
void check_topology(const Topology& t, int dof);

}  // namespace pmreport::mechanics
