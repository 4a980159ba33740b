// A program on plain numbers, many poses at a time.
#pragma once

#include <core/program/program.hpp>

#include <memory>

namespace pmreport::program {

// Keeps its buffers: one a thread. Steps that depend on no input are done once for all; each other runs over a block of poses that stays in
// the first-level cache, in the vectors of the processor that it runs on. The digits are those of Evaluator<double>, on all processors.
class Batch {
 public:
  explicit Batch(const Program& program);
  // For poses that differ in the inputs alone whose bits are set in `inner`, as along a row of a grid: what the others decide is done once
  // a run. Inputs from the 65th on are among the others.
  Batch(const Program& program, std::uint64_t inner);
  ~Batch();
  Batch(Batch&&) noexcept;

  // Input i of pose k is in[i * count + k], output o out[o * count + k]. Made with `inner`: the inputs that are in it, in their order;
  // `others` has one number for each input of the program, of which those in `inner` are not looked at.
  void run(std::size_t count, const double* in, double* out) { run(count, nullptr, in, out); }
  void run(std::size_t count, const double* others, const double* in, double* out);

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

// A program in two by what changes: `outer` computes from all inputs what does not depend on the inputs whose bits are set in `inner`;
// `inner` computes the outputs from all inputs, then outer's outputs. A scan runs the one a row, the other a pose. Comparisons are no
// outputs: `inner` makes those of a row again, from the numbers that they compare.
struct Split {
  Program outer, inner;
};
Split split(const Program& program, std::uint64_t inner);
Split split(const Program& program, const std::vector<bool>& inner);  // one an input

}  // namespace pmreport::program
