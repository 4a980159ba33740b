#include <algorithm>
#include <core/program/intervals/boxes.hpp>
#include <core/program/intervals/boxes_block.hpp>
#include <core/program/intervals/rounding.hpp>
#include <vector>

namespace pmreport::program {

namespace {

using Kind = BoxInstruction::Kind;

// Steps as instructions on as few registers as there are values alive at a time: what is not needed again makes room for the next.
class Assembler {
 public:
  explicit Assembler(const Program& program)
      : program_(program), last_use_(program.steps().size(), -1), register_(last_use_.size(), -1), outputs_(last_use_.size()) {
    for (std::size_t o = 0; o < program.outputs().size(); ++o) outputs_[index(program.outputs()[o])].push_back(static_cast<int>(o));
    for (int i = 0; i < count(); ++i)
      for (const int x : operands_in_registers(step(i))) last_use_[index(x)] = i;
    for (int i = 0; i < count(); ++i) append(i);
  }

  std::vector<BoxInstruction> instructions() && { return std::move(instructions_); }
  int registers() const { return registers_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  int count() const { return static_cast<int>(program_.steps().size()); }
  const Step& step(int i) const { return program_.steps()[index(i)]; }
  bool is_constant(int i) const { return step(i).operation == Operation::constant; }

  // How a step with a constant for an operand is done without a register for it: the other operand in `a`.
  struct ByConstant {
    Kind kind = Kind::step;
    int a = 0;
    double constant = 0;
  };
  ByConstant by_constant(const Step& s) const {
    const bool with_a = operands_of(s.operation) == 2 && is_constant(s.a), with_b = operands_of(s.operation) == 2 && is_constant(s.b);
    switch (s.operation) {
      case Operation::add:
        if (with_b) return {Kind::add_constant, s.a, step(s.b).constant};
        if (with_a) return {Kind::add_constant, s.b, step(s.a).constant};
        break;
      case Operation::subtract:
        if (with_b) return {Kind::add_constant, s.a, -step(s.b).constant};
        if (with_a) return {Kind::constant_minus, s.b, step(s.a).constant};
        break;
      case Operation::multiply:
        if (with_b) return {Kind::multiply_constant, s.a, step(s.b).constant};
        if (with_a) return {Kind::multiply_constant, s.b, step(s.a).constant};
        break;
      case Operation::divide:
        if (with_b) return {Kind::divide_constant, s.a, step(s.b).constant};
        break;
      default:
        break;
    }
    return {};
  }

  std::vector<int> operands_in_registers(const Step& s) const {
    if (const ByConstant by = by_constant(s); by.kind != Kind::step) return {by.a};
    const int operands[] = {s.a, s.b, s.c};
    return {operands, operands + operands_of(s.operation)};
  }

  // The register of a value; constants get theirs when they are first needed.
  int register_of(int i) {
    int& r = register_[index(i)];
    if (r < 0) {
      r = take();
      instructions_.push_back({Kind::fill, Operation::constant, r, r, r, r, step(i).constant});
    }
    return r;
  }
  int take() {
    if (free_.empty()) return registers_++;
    const int r = free_.back();
    free_.pop_back();
    return r;
  }

  void append(int i) {
    const Step& s = step(i);
    if (is_constant(i)) {
      store(i);
      return;
    }
    std::vector<int> operands = operands_in_registers(s), at;
    for (const int x : operands) at.push_back(register_of(x));
    const int target = register_[index(i)] = take();  // before the operands leave theirs: they stay apart
    at.resize(3, target);
    BoxInstruction instruction{Kind::step, s.operation, target, at[0], at[1], at[2], 0};
    if (s.operation == Operation::input) {
      instruction.kind = Kind::load;
      instruction.a = s.a;
    } else if (const ByConstant by = by_constant(s); by.kind != Kind::step) {
      instruction.kind = by.kind;
      instruction.constant = by.constant;
    }
    instructions_.push_back(instruction);
    store(i);

    operands.push_back(i);  // what is an output and no more
    std::sort(operands.begin(), operands.end());
    operands.erase(std::unique(operands.begin(), operands.end()), operands.end());
    for (const int x : operands)
      if (last_use_[index(x)] <= i) free_.push_back(register_[index(x)]);
  }

  void store(int i) {
    for (const int o : outputs_[index(i)])
      instructions_.push_back({is_constant(i) ? Kind::store_constant : Kind::store, Operation::constant, 0, o,
                               std::max(register_[index(i)], 0), 0, step(i).constant});
  }

  const Program& program_;
  std::vector<int> last_use_, register_, free_;  // of each step; free registers
  std::vector<std::vector<int>> outputs_;        // of each step
  std::vector<BoxInstruction> instructions_;
  int registers_ = 0;
};

struct alignas(64) Line {
  double numbers[8];
};

}  // namespace

struct Boxes::Work {
  std::vector<BoxInstruction> instructions;
  std::vector<Line> lines;
  BoxRegisters registers;

  explicit Work(const Program& program) {
    Assembler assembler(program);
    const std::size_t count = static_cast<std::size_t>(std::max(assembler.registers(), 1));
    // A block fills most of a first-level cache of 32 KiB, but is so long that choosing an instruction costs little beside it.
    constexpr std::size_t cache = 24 * 1024, shortest = 16, longest = 256;
    registers.pitch = std::clamp(cache / (2 * sizeof(double) * count) / 8 * 8, shortest, longest);
    lines.resize(2 * registers.pitch * count / 8);
    registers.numbers = lines.front().numbers;
    instructions = std::move(assembler).instructions();
  }
};

Boxes::Boxes(const Program& program) : work_(std::make_unique<Work>(program)) {}
Boxes::~Boxes() = default;
Boxes::Boxes(Boxes&&) noexcept = default;

void Boxes::run(std::size_t count, const Bounds* in, Bounds* out) {
  round_upward([&] {
    const std::size_t block = work_->registers.pitch;
    for (std::size_t first = 0; first < count; first += block)
      run_block(work_->instructions, work_->registers, {in + first, out + first, count, std::min(block, count - first)});
  });
}

}  // namespace pmreport::program
