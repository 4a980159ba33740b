// Properties that need a pose and no motion: what the joints leave free, and whether home is a pose to start from.
#pragma once

#include <core/mechanics/conformance/property_list.hpp>

namespace pmreport::mechanics {

// Mobility, and constraint wrenches by limbs, at a pose; nothing where it is out of reach. `length`: characteristic_length(machine) [m].
void look_at_rest(const Machine& machine, const Eigen::VectorXd& coordinates, double length, PropertyList& properties);

// The same at home, and whether home and G there are regular. `beside`: poses near home, out of reach or not.
void look_at_home(const Machine& machine, const std::vector<Eigen::VectorXd>& beside, double length, PropertyList& properties);

}  // namespace pmreport::mechanics
