// What decides the answers of a scan, as a number that tells scans apart.
#pragma once

#include <core/scan/pose_set.hpp>

#include <cstdint>

namespace pmreport::scan {

// All of the set but what its late margins are made from, and all of the scan.
std::uint64_t meaning_of(const PoseSet& set, const Scan& scan);
std::uint64_t meaning_of(const program::Program& p);

}  // namespace pmreport::scan
