// A program with guides: inputs that change how narrowly intervals bound its outputs, and never which sign an output has.
#pragma once

#include <core/program/program.hpp>

#include <cstddef>
#include <functional>

namespace pmreport::program {

struct Guided {
  Program program;  // inputs: the coordinates, then the guides
  std::size_t guides = 0;
  // Guides that serve a box well, from its middle: coordinate i of pose k at poses[i * count + k], guide g to guides[g * count + k]. Each
  // pose has its own, whatever the others are. Called by several threads at once.
  std::function<void(std::size_t count, const double* poses, double* guides)> choose;
};

}  // namespace pmreport::program
