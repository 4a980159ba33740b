// A ball of poses, and what a box of them has to do with it.
#pragma once

#include <core/program/intervals/bounds.hpp>

#include <span>
#include <vector>

namespace pmreport::scan {

// sum over the free axes of ((x - centre) / proportion)^2 <= radius^2
struct Ball {
  std::vector<double> centre, proportions;  // of each free axis
  double radius = 0;
};

// What a box has to do with a ball, rounded so that it is certain.
struct BallAndBox {
  bool apart = false;       // no pose of the box lies in the ball
  bool middle_in = false;   // the middle does
  bool nearest_in = false;  // the pose of the box that is nearest to the centre does
};
BallAndBox relation(const Ball& ball, std::span<const program::Bounds> sides);

}  // namespace pmreport::scan
