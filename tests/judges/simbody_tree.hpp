// The joints by which Simbody reaches the bodies.
#pragma once

#include <pmreport/topology.hpp>

#include <vector>

namespace pmreport::judges {

// Which joints make the tree, and which body is the parent in each; by joint.
struct SpanningTree {
  static constexpr int left_out = -1;
  std::vector<int> parent;
  std::vector<int> outward;  // joints of the tree, from the base outward
};

// Throws std::invalid_argument where actuated joints close a loop.
SpanningTree spanning_tree(const Topology& topology);

}  // namespace pmreport::judges
