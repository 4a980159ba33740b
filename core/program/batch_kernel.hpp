// The loops of a batch, in the vectors of the processor that they run on.
#pragma once

#include <core/program/program.hpp>

#include <cstddef>
#include <span>

namespace pmreport::program {

// A product that nothing else uses stays in a register: both roundings are those of the two steps.
enum class Fused { none, added, subtracted, subtracted_from };  // a + b c, a - b c, b c - a

// One operation on a block of poses, or two. Its numbers are places in a table of arrays.
struct BlockStep {
  Fused fused;
  Operation operation;  // where nothing is fused
  int to, a, b, c;
  bool same_a, same_b, same_c;  // the array has one number, for all poses
};

// Does the steps on `count` poses, one after the other. `to` may be the array of an operand; else arrays do not overlap. Masks are numbers
// here: one where they hold, else zero.
using BlockKernel = void (*)(std::span<const BlockStep> steps, double* const* arrays, std::size_t count);

// That of the plainest processor first, the best that this one runs last. All give the same digits.
std::span<const BlockKernel> block_kernels();

}  // namespace pmreport::program
