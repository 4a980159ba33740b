// Poses to try a mechanism at.
#pragma once

#include <core/mechanics/machine/machine.hpp>

#include <cstdint>
#include <vector>

namespace pmreport::mechanics {

// Random poses in the box of the coordinates that can be assembled, equally likely everywhere. The same for the same seed on every machine.
// Fewer than asked when the box is mostly out of reach (a thousand tries a pose at most).
std::vector<Eigen::VectorXd> random_poses(const Machine& machine, int count, std::uint64_t seed);

}  // namespace pmreport::mechanics
