// The search on the joints alone: poses with given actuator values, whatever a plugin's `place` can express.
#pragma once

#include <core/mechanics/assembly/assembly.hpp>

#include <span>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

// Newton's method on the loop equations of all bodies, by steps of least norm, which leaves idle spins alone. It starts from modes that are
// known, the platform moved and turned at random, all bodies between base and platform by their share of the way. The same numbers on every
// run. No number of starts proves that there are no more.
//
// `words`: the machines of all working modes, the first of them the one asked about; `known`: modes found so far. Where `place` has the
// platform as well, in some word, the mode is given in `expressed`: word and coordinates.
struct JointSearch {
  FurtherModes further;
  std::vector<std::pair<std::size_t, Eigen::VectorXd>> expressed;
};
JointSearch search_joints(std::span<const std::unique_ptr<Machine>> words, const Eigen::VectorXd& actuators,
                          const Eigen::VectorXd& reference, const std::vector<AssemblyMode>& known, int starts);

}  // namespace pmreport::mechanics
