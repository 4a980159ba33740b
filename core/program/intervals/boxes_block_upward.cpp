#include <core/program/intervals/boxes_block.hpp>
#include <core/program/intervals/interval.hpp>

// The same formulas, compiled for each level of the x86-64 psABI; the best that the processor has is taken when the program starts. With
// all calls inside inlined, for no function of the standard library may stay behind that is compiled for one level and taken for another.
// Sanitizers of memory and threads are not ready when that choice is made.
#if defined(__x86_64__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define PMREPORT_FOR_EACH_LEVEL [[gnu::flatten, gnu::target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")]]
#else
#define PMREPORT_FOR_EACH_LEVEL
#endif

namespace pmreport::program {

namespace {

using Kind = BoxInstruction::Kind;

Interval interval_at(const double* ends, std::size_t pitch, std::size_t k) { return Interval::of_ends(ends[k], ends[pitch + k]); }
Interval::Mask mask_at(const double* ends, std::size_t pitch, std::size_t k) { return {ends[k] != 0, ends[pitch + k] != 0}; }
void put(double* ends, std::size_t pitch, std::size_t k, const Interval& x) {
  ends[k] = x.negative_low;
  ends[pitch + k] = x.high;
}
void put(double* ends, std::size_t pitch, std::size_t k, const Interval::Mask& m) {
  ends[k] = m.yes ? 1 : 0;
  ends[pitch + k] = m.no ? 1 : 0;
}

// The target is none of the operands, which the compiler does not know.
template <class F>
void each(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes, F&& f) {
  double* target = r.at(i.target);
  const double *a = r.at(i.a), *b = r.at(i.b), *c = r.at(i.c);
  const std::size_t pitch = r.pitch;
#pragma GCC ivdep
  for (std::size_t k = 0; k < boxes; ++k) put(target, pitch, k, f(a, b, c, pitch, k));
}
template <class F>
void each_of_one(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes, F&& f) {
  each(i, r, boxes,
       [&f](const double* a, const double*, const double*, std::size_t pitch, std::size_t k) { return f(interval_at(a, pitch, k)); });
}
template <class F>
void each_of_two(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes, F&& f) {
  each(i, r, boxes, [&f](const double* a, const double* b, const double*, std::size_t pitch, std::size_t k) {
    return f(interval_at(a, pitch, k), interval_at(b, pitch, k));
  });
}
template <class F>
void each_of_masks(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes, F&& f) {
  each(i, r, boxes, [&f](const double* a, const double* b, const double*, std::size_t pitch, std::size_t k) {
    return f(mask_at(a, pitch, k), mask_at(b, pitch, k));
  });
}

bool of_the_library(Operation o) { return o == Operation::tan || o == Operation::asin || o == Operation::acos || o == Operation::atan2; }

void run_step(const BoxInstruction& i, const BoxRegisters& r, std::size_t boxes) {
  switch (i.operation) {
    case Operation::add:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return a + b; });
    case Operation::subtract:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return a - b; });
    case Operation::multiply:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return a * b; });
    case Operation::divide:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return a / b; });
    case Operation::negate:
      return each_of_one(i, r, boxes, [](const Interval& a) { return -a; });
    case Operation::sqrt:
      return each_of_one(i, r, boxes, [](const Interval& a) { return sqrt(a); });
    case Operation::sin:
      return each_of_one(i, r, boxes, [](const Interval& a) { return sin(a); });
    case Operation::cos:
      return each_of_one(i, r, boxes, [](const Interval& a) { return cos(a); });
    case Operation::abs:
      return each_of_one(i, r, boxes, [](const Interval& a) { return abs(a); });
    case Operation::hypot:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return hypot(a, b); });
    case Operation::square:
      return each_of_one(i, r, boxes, [](const Interval& a) { return square(a); });
    case Operation::min:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return smaller(a, b); });
    case Operation::max:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return larger(a, b); });
    case Operation::less:
      return each_of_two(i, r, boxes, [](const Interval& a, const Interval& b) { return a < b; });
    case Operation::both:
      return each_of_masks(i, r, boxes, [](const Interval::Mask& a, const Interval::Mask& b) { return a && b; });
    case Operation::either:
      return each_of_masks(i, r, boxes, [](const Interval::Mask& a, const Interval::Mask& b) { return a || b; });
    case Operation::opposite:
      return each_of_masks(i, r, boxes, [](const Interval::Mask& a, const Interval::Mask&) { return !a; });
    case Operation::choose:
      return each(i, r, boxes, [](const double* a, const double* b, const double* c, std::size_t pitch, std::size_t k) {
        return choose(mask_at(a, pitch, k), interval_at(b, pitch, k), interval_at(c, pitch, k));
      });
    case Operation::settled:
      return each(i, r, boxes, [](const double* a, const double* b, const double*, std::size_t pitch, std::size_t k) {
        return settled(mask_at(a, pitch, k), interval_at(b, pitch, k));
      });
    case Operation::uncut:
      return each(i, r, boxes, [](const double* a, const double* b, const double* c, std::size_t pitch, std::size_t k) {
        return uncut(interval_at(a, pitch, k), interval_at(b, pitch, k), interval_at(c, pitch, k));
      });
    default:  // run_function's
      return;
  }
}

}  // namespace

PMREPORT_FOR_EACH_LEVEL void run_block(std::span<const BoxInstruction> instructions, const BoxRegisters& r, const BoxTraffic& traffic) {
  const std::size_t boxes = (traffic.boxes + 7) / 8 * 8;  // the last may hold anything
  for (const BoxInstruction& i : instructions) switch (i.kind) {
      case Kind::load: {
        const Bounds* from = traffic.in + static_cast<std::size_t>(i.a) * traffic.count;
        double* target = r.at(i.target);
        for (std::size_t k = 0; k < traffic.boxes; ++k) put(target, r.pitch, k, Interval(from[k]));
        break;
      }
      case Kind::store: {
        Bounds* to = traffic.out + static_cast<std::size_t>(i.a) * traffic.count;
        const double* from = r.at(i.b);
        for (std::size_t k = 0; k < traffic.boxes; ++k) to[k] = interval_at(from, r.pitch, k).bounds();
        break;
      }
      case Kind::store_constant: {
        Bounds* to = traffic.out + static_cast<std::size_t>(i.a) * traffic.count;
        for (std::size_t k = 0; k < traffic.boxes; ++k) to[k] = Bounds::exactly(i.constant);
        break;
      }
      case Kind::fill:
        each(i, r, boxes, [x = Interval(i.constant)](const double*, const double*, const double*, std::size_t, std::size_t) { return x; });
        break;
      case Kind::step:
        if (of_the_library(i.operation))
          run_function(i, r, traffic.boxes);
        else
          run_step(i, r, boxes);
        break;
      case Kind::add_constant:
        each_of_one(i, r, boxes, [c = i.constant](const Interval& a) { return a + c; });
        break;
      case Kind::constant_minus:
        each_of_one(i, r, boxes, [c = i.constant](const Interval& a) { return c - a; });
        break;
      case Kind::multiply_constant:
        each_of_one(i, r, boxes, [c = i.constant](const Interval& a) { return a * c; });
        break;
      case Kind::divide_constant:
        each_of_one(i, r, boxes, [c = i.constant](const Interval& a) { return a / c; });
        break;
    }
}

}  // namespace pmreport::program
