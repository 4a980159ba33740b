// What Boxes do for one block of boxes: instructions on registers, each a stretch of ends for all boxes of the block.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/program/program.hpp>

#include <cstddef>
#include <span>

namespace pmreport::program {

struct BoxInstruction {
  enum class Kind {
    load,               // input a into the target
    store,              // output a from the register b
    store_constant,     // output a
    fill,               // the constant into the target
    step,               // the operation on registers
    add_constant,       // a + constant
    constant_minus,     // constant - a
    multiply_constant,  // a constant
    divide_constant     // a / constant
  } kind = Kind::step;
  Operation operation = Operation::constant;
  int target = 0;  // a register, none of the operands
  int a = 0, b = 0, c = 0;
  double constant = 0;
};

// Registers: of register r the negative low ends of all boxes from 2 r pitch on, the high ends from (2 r + 1) pitch on. Of masks the same:
// one where the answer is certain, yes or no; else zero.
struct BoxRegisters {
  double* numbers = nullptr;
  std::size_t pitch = 0;  // a multiple of 8: no vector is left over

  double* at(int r) const { return numbers + 2 * pitch * static_cast<std::size_t>(r); }
};

// Bounds of inputs and outputs as of Boxes::run, those of the block's first box first.
struct BoxTraffic {
  const Bounds* in = nullptr;
  Bounds* out = nullptr;
  std::size_t count = 0;  // of all blocks: what one input is from the next
  std::size_t boxes = 0;  // of this block, no more than the pitch
};

// Rounding must go upward.
void run_block(std::span<const BoxInstruction> instructions, const BoxRegisters& registers, const BoxTraffic& traffic);

// What the mathematical library computes, one box after the other.
void run_function(const BoxInstruction& i, const BoxRegisters& registers, std::size_t boxes);

}  // namespace pmreport::program
