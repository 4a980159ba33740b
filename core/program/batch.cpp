#include <core/program/batch.hpp>
#include <core/program/batch_kernel.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace pmreport::program {

// The steps of a program by how often they are done: once for all, once a run, for every pose. Those for every pose have an array each:
// of the caller, where they are inputs or outputs; else a register of one block, which is free again after the step that uses it last.
struct Batch::Work {
  Work(const Program& program, auto&& varies);

  void fix(const Program& program);
  void place(const Program& program);
  std::vector<BlockStep> fuse(const Program& program, const std::vector<bool>& is_output) const;
  std::size_t index(int step) const { return static_cast<std::size_t>(step); }
  bool same(int step) const { return often[index(step)] != pose; }

  enum Often : unsigned char { once, run, pose };
  std::vector<Often> often;     // of each step
  std::vector<double> fixed;    // the value of each step that is not for every pose
  std::vector<double*> arrays;  // of each step
  std::vector<double> registers;
  std::size_t block = 0;
  std::vector<BlockStep> a_run, a_pose;

  struct Link {
    int step;
    std::size_t number;
  };
  std::vector<Link> others, inputs;   // steps that are inputs; the numbers of inputs, or places among the inner ones
  std::vector<Link> written, copied;  // steps that are outputs, and their numbers: computed there, or copied to there afterwards
};

namespace {

constexpr std::size_t first_level = 32 * 1024;  // [bytes] of the cache that a block may fill: most processors have that much, or half more
constexpr std::size_t line = 64;                // [bytes] of that cache
constexpr std::size_t shortest = 128, longest = 512, grain = 64;  // poses: a step costs as much as some ten of them before the first

BlockStep block_step(const Step& s, int to, auto&& same) {
  const int n = operands_of(s.operation);
  return {Fused::none, s.operation, to, s.a, s.b, s.c, n > 0 && same(s.a), n > 1 && same(s.b), n > 2 && same(s.c)};
}

}  // namespace

Batch::Work::Work(const Program& program, auto&& varies)
    : often(program.steps().size(), once), fixed(program.steps().size()), arrays(program.steps().size()) {
  const std::span<const Step> steps = program.steps();
  std::size_t inner = 0;
  std::vector<std::size_t> place_of(static_cast<std::size_t>(program.inputs()));
  for (int i = 0; i < program.inputs(); ++i)
    if (varies(i)) place_of[index(i)] = inner++;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& s = steps[i];
    if (s.operation == Operation::input) {
      often[i] = varies(s.a) ? pose : run;
      if (varies(s.a))
        inputs.push_back({static_cast<int>(i), place_of[index(s.a)]});
      else
        others.push_back({static_cast<int>(i), index(s.a)});
    }
    const int operands[] = {s.a, s.b, s.c};
    for (int k = 0; k < operands_of(s.operation); ++k) often[i] = std::max(often[i], often[index(operands[k])]);
  }
  fix(program);
  place(program);
}

void Batch::Work::fix(const Program& program) {
  const std::span<const Step> steps = program.steps();
  std::vector<BlockStep> first;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    arrays[i] = &fixed[i];
    const Step& s = steps[i];
    if (s.operation == Operation::constant) fixed[i] = s.constant;
    if (operands_of(s.operation) == 0 || often[i] == pose) continue;
    (often[i] == once ? first : a_run).push_back(block_step(s, static_cast<int>(i), [](int) { return false; }));
  }
  block_kernels().front()(first, arrays.data(), 1);
}

// The steps for every pose, a product together with the sum or difference that alone uses it.
std::vector<BlockStep> Batch::Work::fuse(const Program& program, const std::vector<bool>& is_output) const {
  const std::span<const Step> steps = program.steps();
  const auto every_pose = [&](std::size_t i) { return often[i] == pose && steps[i].operation != Operation::input; };
  std::vector<int> uses(steps.size(), 0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const int operands[] = {steps[i].a, steps[i].b, steps[i].c};
    for (int k = 0; every_pose(i) && k < operands_of(steps[i].operation); ++k) ++uses[index(operands[k])];
  }
  const auto joins = [&](int step) {
    const std::size_t i = index(step);
    return steps[i].operation == Operation::multiply && every_pose(i) && uses[i] == 1 && !is_output[i];
  };
  const auto is_same = [this](int step) { return same(step); };
  std::vector<BlockStep> out;
  std::vector<std::size_t> place(steps.size());  // of each step, in `out`
  std::vector<bool> joined;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (!every_pose(i)) continue;
    const Step& s = steps[i];
    place[i] = out.size();
    BlockStep block = block_step(s, static_cast<int>(i), is_same);
    const bool sum = s.operation == Operation::add, difference = s.operation == Operation::subtract;
    if ((sum || difference) && (joins(s.a) || joins(s.b))) {
      const bool second = joins(s.b);
      const int product = second ? s.b : s.a, other = second ? s.a : s.b;
      const Step& m = steps[index(product)];
      block = {sum      ? Fused::added
               : second ? Fused::subtracted
                        : Fused::subtracted_from,
               s.operation,
               static_cast<int>(i),
               other,
               m.a,
               m.b,
               same(other),
               same(m.a),
               same(m.b)};
      joined[place[index(product)]] = true;
    }
    out.push_back(block);
    joined.push_back(false);
  }
  std::erase_if(out, [&, k = std::size_t{0}](const BlockStep&) mutable { return joined[k++]; });
  return out;
}

void Batch::Work::place(const Program& program) {
  const std::span<const Step> steps = program.steps();
  std::vector<bool> is_output(steps.size());
  for (std::size_t o = 0; o < program.outputs().size(); ++o) {
    const int step = program.outputs()[o];
    const bool computed_there = !same(step) && steps[index(step)].operation != Operation::input && !is_output[index(step)];
    (computed_there ? written : copied).push_back({step, o});
    is_output[index(step)] = is_output[index(step)] || computed_there;
  }

  a_pose = fuse(program, is_output);
  const auto operands_of_block = [](const BlockStep& s) {
    const std::array<int, 3> all{s.a, s.b, s.c};
    return std::pair(all, s.fused == Fused::none ? operands_of(s.operation) : 3);
  };
  std::vector<std::size_t> last(steps.size(), 0);
  for (std::size_t i = 0; i < a_pose.size(); ++i)
    for (auto [operands, n] = operands_of_block(a_pose[i]); n-- > 0;) last[index(operands[index(n)])] = i;
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> register_of(steps.size(), none), free;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a_pose.size(); ++i) {
    const auto [operands, n] = operands_of_block(a_pose[i]);
    for (int k = 0; k < n; ++k) {
      const std::size_t x = index(operands[index(k)]);
      const bool told_before = std::find(operands.begin(), operands.begin() + k, operands[index(k)]) != operands.begin() + k;
      if (last[x] == i && register_of[x] != none && !told_before) free.push_back(register_of[x]);
    }
    const std::size_t to = index(a_pose[i].to);
    if (is_output[to]) continue;
    if (free.empty()) free.push_back(count++);
    register_of[to] = free.back();
    free.pop_back();
  }

  const std::size_t streams = count + inputs.size() + written.size();
  block = std::clamp(first_level / sizeof(double) / std::max<std::size_t>(streams, 1) / grain * grain, shortest, longest);
  // On the borders of cache lines: a vector across one costs twice.
  registers.resize(count * block + line / sizeof(double));
  const std::size_t past = reinterpret_cast<std::uintptr_t>(registers.data()) % line;
  double* first = registers.data() + (past == 0 ? 0 : (line - past) / sizeof(double));
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (register_of[i] != none) arrays[i] = first + register_of[i] * block;
}

Batch::Batch(const Program& program) : work_(std::make_unique<Work>(program, [](int) { return true; })) {}
Batch::Batch(const Program& program, std::uint64_t inner)
    : work_(std::make_unique<Work>(program, [inner](int i) { return i < 64 && (inner >> i & 1) != 0; })) {}
Batch::~Batch() = default;
Batch::Batch(Batch&&) noexcept = default;

void Batch::run(std::size_t count, const double* others, const double* in, double* out) {
  Work& w = *work_;
  const BlockKernel kernel = block_kernels().back();
  for (const auto& [step, number] : w.others) w.fixed[w.index(step)] = others[number];
  kernel(w.a_run, w.arrays.data(), 1);
  for (std::size_t start = 0; start < count; start += w.block) {
    const std::size_t n = std::min(w.block, count - start);
    // A kernel only reads what no step has as its result.
    for (const auto& [step, number] : w.inputs) w.arrays[w.index(step)] = const_cast<double*>(in + number * count + start);
    for (const auto& [step, number] : w.written) w.arrays[w.index(step)] = out + number * count + start;
    kernel(w.a_pose, w.arrays.data(), n);
    for (const auto& [step, number] : w.copied) {
      const double* from = w.arrays[w.index(step)];
      if (w.same(step))
        std::fill_n(out + number * count + start, n, *from);
      else
        std::copy_n(from, n, out + number * count + start);
    }
  }
}

}  // namespace pmreport::program
