// What a mechanism declares of itself, as structs of C++.
#pragma once

#include <pmreport/plugin.h>
#include <pmreport/topology.hpp>

namespace pmreport::mechanics {

// All that an instance declares, unchecked but for lists that must be as long as one another. Throws MechanismError (PM_FAILED) when it
// cannot tell.
Topology read_topology(const pm_mechanism& table, const pm_instance* instance);

}  // namespace pmreport::mechanics
