// A straight-line program: geometry as data. A few hundred operations on numbered values, no loops, no branches; each step uses earlier
// ones. From a plugin's recording (pmreport/plugin.h), with what the host records on top (recorder.hpp).
#pragma once

#include <pmreport/plugin.h>

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace pmreport::program {

// Those of the contract under the contract's numbers; then what patterns of them mean, which other kinds of numbers must see to be sharp:
// of intervals, x x is never negative, and choose(a < b, a, b) is no more than either.
enum class Operation : std::uint8_t {
  constant = PM_OP_CONSTANT,
  input = PM_OP_INPUT,
  add = PM_OP_ADD,
  subtract = PM_OP_SUBTRACT,
  multiply = PM_OP_MULTIPLY,
  divide = PM_OP_DIVIDE,
  negate = PM_OP_NEGATE,
  sqrt = PM_OP_SQRT,
  sin = PM_OP_SIN,
  cos = PM_OP_COS,
  tan = PM_OP_TAN,
  asin = PM_OP_ASIN,
  acos = PM_OP_ACOS,
  abs = PM_OP_ABS,
  atan2 = PM_OP_ATAN2,
  hypot = PM_OP_HYPOT,
  less = PM_OP_LESS,  // gives a mask; so do the next three, from masks
  both = PM_OP_AND,
  either = PM_OP_OR,
  opposite = PM_OP_NOT,
  choose = PM_OP_CHOOSE,
  square = PM_OP_COUNT,
  min,
  max,
  // The first operands tell whether the last, the derivative of something, is one at all: of numbers it is passed on; of intervals nothing
  // is known of it where that something jumps.
  settled,  // of choose(a, ., .): b, unless the mask a is open
  uncut     // of atan2(a, b): c, unless the interval of the angle is cut
};
int operands_of(Operation o);      // 0 to 3
bool gives_mask(Operation o);      // less, both, either, opposite
const char* name_of(Operation o);  // "add"

struct Step {
  Operation operation = Operation::constant;
  int a = 0, b = 0, c = 0;  // earlier steps, as many as it has operands; of an input its number; else 0
  double constant = 0;

  bool operator==(const Step&) const = default;
};

// A list of steps that is no program. The sentence completes "the mechanism records ".
struct ProgramError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Program {
 public:
  Program() = default;  // of nothing
  // Takes the steps that the outputs need. Equal operations become one, what constants come to without rounding a constant, and patterns
  // what they mean: 1 x, x + 0, x x, choose(a < b, a, b). What is multiplied by zero is taken to be finite. Throws ProgramError: a step
  // that uses no earlier one, a mask for a number or a number for a mask, an operation that does not exist, a constant that is not finite,
  // more than `most_steps`.
  Program(std::span<const Step> steps, int inputs, std::span<const int> outputs);

  static constexpr std::size_t most_steps = 1 << 16;

  int inputs() const { return inputs_; }
  // Not of a program that is gone at the end of the expression: a loop over them would run through freed memory.
  std::span<const Step> steps() const& { return steps_; }
  std::span<const Step> steps() const&& = delete;
  std::span<const int> outputs() const& { return outputs_; }  // steps
  std::span<const int> outputs() const&& = delete;
  bool operator==(const Program&) const = default;

  // The program of some of its outputs, by their numbers, in that order.
  Program slice(std::span<const int> outputs) const;
  // Of each step the inputs that it depends on, one bit each; at most 64 inputs.
  std::vector<std::uint64_t> dependence() const;

 private:
  std::vector<Step> steps_;
  std::vector<int> outputs_;
  int inputs_ = 0;
};

// What `outer` gives where its inputs are the outputs of `inner`, one each.
Program composed(const Program& outer, const Program& inner);

// Both programs of the same inputs as one: the outputs of `second` behind those of `first`.
Program joined(const Program& first, const Program& second);

// A plugin's recording as steps. Throws ProgramError.
std::vector<Step> steps_of(std::span<const pm_step> recorded);

}  // namespace pmreport::program
