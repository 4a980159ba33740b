#include <core/program/batch_kernel.hpp>

#include <core/vectors.hpp>

#include <cmath>
#include <vector>

namespace pmreport::program {

namespace {

// An array, or one number for all poses.
struct Array {
  const double* at;
  double operator()(std::size_t k) const { return at[k]; }
};
struct Same {
  double x;
  double operator()(std::size_t) const { return x; }
};

// f(operand) with what a step reads there.
template <class F>
[[gnu::always_inline]] inline void with(const double* at, bool same, F&& f) {
  if (same)
    f(Same{*at});
  else
    f(Array{at});
}

class Block {
 public:
  Block(const BlockStep& step, double* const* arrays, std::size_t count) : s_(step), arrays_(arrays), count_(count) {}

  template <class F>
  void unary(F f) const {
    const Array x{arrays_[s_.a]};
    each([&](std::size_t k) { return f(x(k)); });
  }
  template <class F>
  void binary(F f) const {
    with(arrays_[s_.a], s_.same_a,
         [&](auto x) { with(arrays_[s_.b], s_.same_b, [&](auto y) { each([&](std::size_t k) { return f(x(k), y(k)); }); }); });
  }
  template <class F>
  void ternary(F f) const {
    with(arrays_[s_.a], s_.same_a, [&](auto x) {
      with(arrays_[s_.b], s_.same_b,
           [&](auto y) { with(arrays_[s_.c], s_.same_c, [&](auto z) { each([&](std::size_t k) { return f(x(k), y(k), z(k)); }); }); });
    });
  }
  // What is passed on, operand b or c.
  void pass(int operand, bool same) const {
    with(arrays_[operand], same, [&](auto x) { each([&](std::size_t k) { return x(k); }); });
  }

 private:
  template <class F>
  void each(F f) const {
    double* to = arrays_[s_.to];
#ifndef __clang__  // which asks before every loop whether arrays overlap, and cannot promise what is called in them
#pragma GCC ivdep
#endif
    for (std::size_t k = 0; k < count_; ++k) to[k] = f(k);
  }

  const BlockStep& s_;
  double* const* arrays_;
  std::size_t count_;
};

[[gnu::always_inline]] inline void run(std::span<const BlockStep> steps, double* const* arrays, std::size_t count) {
  for (const BlockStep& s : steps) {
    const Block block(s, arrays, count);
    if (s.fused == Fused::added) {
      block.ternary([](double x, double y, double z) { return x + y * z; });
      continue;
    }
    if (s.fused == Fused::subtracted) {
      block.ternary([](double x, double y, double z) { return x - y * z; });
      continue;
    }
    if (s.fused == Fused::subtracted_from) {
      block.ternary([](double x, double y, double z) { return y * z - x; });
      continue;
    }
    switch (s.operation) {
      case Operation::add:
        block.binary([](double x, double y) { return x + y; });
        break;
      case Operation::subtract:
        block.binary([](double x, double y) { return x - y; });
        break;
      case Operation::multiply:
        block.binary([](double x, double y) { return x * y; });
        break;
      case Operation::divide:
        block.binary([](double x, double y) { return x / y; });
        break;
      case Operation::negate:
        block.unary([](double x) { return -x; });
        break;
      case Operation::sqrt:
        block.unary([](double x) { return std::sqrt(x); });
        break;
      case Operation::sin:
        block.unary([](double x) { return std::sin(x); });
        break;
      case Operation::cos:
        block.unary([](double x) { return std::cos(x); });
        break;
      case Operation::tan:
        block.unary([](double x) { return std::tan(x); });
        break;
      case Operation::asin:
        block.unary([](double x) { return std::asin(x); });
        break;
      case Operation::acos:
        block.unary([](double x) { return std::acos(x); });
        break;
      case Operation::abs:
        block.unary([](double x) { return std::abs(x); });
        break;
      case Operation::atan2:
        block.binary([](double x, double y) { return std::atan2(x, y); });
        break;
      case Operation::hypot:
        block.binary([](double x, double y) { return std::hypot(x, y); });
        break;
      case Operation::square:
        block.unary([](double x) { return x * x; });
        break;
      case Operation::min:
        block.binary([](double x, double y) { return x < y ? x : y; });
        break;
      case Operation::max:
        block.binary([](double x, double y) { return x < y ? y : x; });
        break;
      case Operation::less:
        block.binary([](double x, double y) { return x < y ? 1.0 : 0.0; });
        break;
      case Operation::both:
        block.binary([](double x, double y) { return x * y; });
        break;
      case Operation::either:
        block.binary([](double x, double y) { return x < y ? y : x; });
        break;
      case Operation::opposite:
        block.unary([](double x) { return 1 - x; });
        break;
      case Operation::choose:
        block.ternary([](double mask, double x, double y) { return mask != 0 ? x : y; });
        break;
      case Operation::settled:
        block.pass(s.b, s.same_b);
        break;
      case Operation::uncut:
        block.pass(s.c, s.same_c);
        break;
      case Operation::constant:
      case Operation::input:
        break;
    }
  }
}

[[gnu::flatten]] void run_plain(std::span<const BlockStep> steps, double* const* arrays, std::size_t count) { run(steps, arrays, count); }
#if defined(__x86_64__)
[[gnu::flatten, gnu::target("arch=x86-64-v3")]] void run_v3(std::span<const BlockStep> steps, double* const* arrays, std::size_t count) {
  run(steps, arrays, count);
}
[[gnu::flatten, gnu::target("arch=x86-64-v4")]] void run_v4(std::span<const BlockStep> steps, double* const* arrays, std::size_t count) {
  run(steps, arrays, count);
}
#endif

}  // namespace

std::span<const BlockKernel> block_kernels() {
  static const std::vector<BlockKernel> all = [] {
    std::vector<BlockKernel> out{run_plain};
#if defined(__x86_64__)
    if (vector_level() >= 3) out.push_back(run_v3);
    if (vector_level() >= 4) out.push_back(run_v4);
#endif
    return out;
  }();
  return all;
}

}  // namespace pmreport::program
