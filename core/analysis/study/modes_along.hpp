// The assembly modes that accompany a motion.
#pragma once

#include <core/analysis/analysis.hpp>
#include <core/mechanics/assembly/follow.hpp>

#include <vector>

namespace pmreport::analysis {

struct ModesAlong {
  mechanics::ModeTracks tracks;
  std::vector<std::size_t> numbers;  // of the tracks: those of the modes found at the start, from 1; then those found later
  bool closed = false;               // the first and the last sample have one pose
};

// `found`: the modes at a sample of the motion. All are searched at both ends of the motion as thoroughly as there, and on the way in
// short.
ModesAlong modes_along(const Analysis& a, const mechanics::AssemblyModes& found, int sample, const mechanics::AssemblyOptions& options);

}  // namespace pmreport::analysis
