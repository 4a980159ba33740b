// The margins of a set taken apart, so that intervals can tell more of them.
#pragma once

#include <core/program/program.hpp>

#include <vector>

namespace pmreport::scan {

// The same set of poses, by more margins. Output m stands for output m of `margins`; further ones follow.
//
// The least of several numbers, as reach is recorded, is not negative where all of them are, and each is smoother than the least of them.
//
// A square root ends where what is under it becomes negative, as at the end of reach, and over a box that holds such an end nothing is
// known of what is computed from it. There the pose is none: so what is under the root becomes a margin of its own, and the root is taken
// of that or zero, whichever is the larger. Where all margins are kept both are the same; where one is not the pose does not count.
struct TakenApart {
  program::Program program;
  std::vector<int> part_of;  // of each output, the margin that it is a part of; what is under a root is one of the reach, margin 0
};
TakenApart taken_apart(const program::Program& margins);

}  // namespace pmreport::scan
