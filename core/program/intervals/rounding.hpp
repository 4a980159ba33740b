// Rounding upward, for a while.
//
// What interval.hpp computes is true only while the processor rounds upward, and a compiler believes that the rounding mode never changes:
// it computes ahead what is constant, and moves arithmetic across the change. So intervals have two rules.
//   1. They are used in files named *_upward.cpp alone, which the build compiles with -frounding-math: nothing is computed ahead, and
//      -(a + b) does not become -a - b.
//   2. Within such a file nothing is computed in the function that changes the mode, but in one that it calls and that the compiler knows
//      nothing of; even a call may be moved, when the compiler sees that it has no effects. round_upward does both:
//
//        Bounds sum(Bounds a, Bounds b) {
//          return round_upward([&] { return (Interval(a) + Interval(b)).bounds(); });
//        }
//
// Eigen on plain numbers, drawing and plugins are not to run within: they would round upward too.
#pragma once

#include <cfenv>
#include <utility>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace pmreport::program {

// Rounds upward from here to the end of its life, then as before; whatever ends it. Lives may be nested. Numbers below 2^-1022 are numbers
// within: a library that was built with -ffast-math makes zeros of them from the moment that it is loaded, in its host too.
class Upward {
 public:
  Upward() : before_(std::fegetround()) {
    std::fesetround(FE_UPWARD);
#if defined(__SSE2__)
    flushing_ = _mm_getcsr() & flush;
    if (flushing_ != 0) _mm_setcsr(_mm_getcsr() & ~flush);
#endif
  }
  ~Upward() {
    std::fesetround(before_);
#if defined(__SSE2__)
    if (flushing_ != 0) _mm_setcsr(_mm_getcsr() | flushing_);
#endif
  }
  Upward(const Upward&) = delete;
  Upward& operator=(const Upward&) = delete;

 private:
  static constexpr unsigned flush = 0x8040;  // results to zero, operands to zero

  int before_;
  unsigned flushing_ = 0;
};

#if defined(__clang__)
#define PMREPORT_UNSEEN [[gnu::noinline]]  // with -frounding-math Clang takes every call for one that reads the mode
#else
#define PMREPORT_UNSEEN [[gnu::noipa]]
#endif

// f(), where the compiler sees nothing of it.
template <class F>
PMREPORT_UNSEEN decltype(auto) unseen(F& f) {
  return f();
}

// f() with rounding upward.
template <class F>
decltype(auto) round_upward(F&& f) {
  const Upward upward;
  return unseen(f);
}

}  // namespace pmreport::program
