// Makes the plan of a mechanism, and tries it.
#pragma once

#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/reactions/by_limb/plan.hpp>

#include <optional>

namespace pmreport::mechanics {

// None where the structure does not fit: an actuator on a joint that must be cut, bodies that hang on the platform alone, idle freedoms
// that are not the declared spins of slender bodies, too few reactions to hold the platform.
std::optional<DynamicsPlan> plan_of(const Machine& machine);

}  // namespace pmreport::mechanics
