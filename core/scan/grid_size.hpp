// How large a grid is, before it is counted.
#pragma once

#include <core/scan/pose_set.hpp>

#include <cstdint>

namespace pmreport::scan {

// Poses of a grid. Throws std::length_error with a sentence: more than can be counted.
std::uint64_t poses_of(const Scan& scan);

}  // namespace pmreport::scan
