// Numbers without the divisors that they share.
//
// What is asked of the direction of a vector alone need not divide its components by a length, and over boxes of poses every division that
// is left out makes bounds narrower: the unit vector of a leg becomes the leg, which is linear in the coordinates.
#pragma once

#include <core/program/program.hpp>

#include <cstddef>

namespace pmreport::program {

// The same program but that the outputs of each `group` in turn, so many at a time and the rest last, are multiplied by what all of them
// are divided by, as far as sums and products show it. Of either sign. Where it is zero the outputs have values that they had not: what is
// told of all poses of a box is told of these poses by their neighbours.
Program without_common_divisors(const Program& program, std::size_t group);

}  // namespace pmreport::program
