// The closed chains of a mechanism.
#pragma once

#include <pmreport/topology.hpp>

#include <string>
#include <vector>

namespace pmreport::mechanics {

// Joint k connects bodies k and k + 1, the last one the last body and the first.
struct Loop {
  std::vector<int> bodies, joints;
};

// Loops of which every other is a combination, the smallest first, as many as shortest ways show.
std::vector<Loop> loops(const Topology& topology);

// "base – A1 – cylinder 1 – ... – base".
std::string in_words(const Topology& topology, const Loop& loop);

}  // namespace pmreport::mechanics
