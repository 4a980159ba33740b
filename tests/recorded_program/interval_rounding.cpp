// Whoever asks for intervals finds the rounding mode afterwards as it was.
#include <array>
#include <catch2/catch.hpp>
#include <cfenv>
#include <core/program/intervals/boxes.hpp>
#include <core/program/intervals/rounding.hpp>
#include <core/program/recorder.hpp>
#include <stdexcept>

#if defined(__SSE2__)
#include <pmmintrin.h>
#endif

using namespace pmreport;
using namespace pmreport::program;

namespace {

constexpr std::array modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

// With every mode set before; leaves it as it was.
template <class Check>
void in_every_mode(Check&& check) {
  const int before = std::fegetround();
  for (const int mode : modes) {
    std::fesetround(mode);
    check();
    const int after = std::fegetround();
    std::fesetround(before);
    CHECK(after == mode);
  }
}

// One third, as the mode has it: what the processor does, not what it says.
int mode_by_arithmetic() {
  volatile double one = 1, three = 3;
  const bool up = one / three > 1.0 / 3, down = -one / three < -1.0 / 3;  // the nearest is below
  return up && down ? 2 : up ? FE_UPWARD : down ? FE_DOWNWARD : FE_TONEAREST;
}

Program sine_and_root() {
  Recorder recorder(2);
  const Recorded x = recorder.input(0), y = recorder.input(1);
  const std::array<Recorded, 2> outputs{sin(x) / y, sqrt(x)};
  return recorder.finish(outputs);
}

}  // namespace

TEST_CASE("rounding goes upward for a while, and then as it did") {
  REQUIRE(mode_by_arithmetic() == FE_TONEAREST);
  {
    const Upward upward;
    const int within = mode_by_arithmetic();
    CHECK(within == FE_UPWARD);
  }
  CHECK(mode_by_arithmetic() == FE_TONEAREST);
  in_every_mode([] { const Upward upward; });
  in_every_mode([] { round_upward([] {}); });
}

TEST_CASE("lives of upward rounding nest") {
  in_every_mode([] {
    const Upward outer;
    { const Upward inner; }
    const bool still = std::fegetround() == FE_UPWARD;
    if (!still) throw std::logic_error("the inner life ended the outer");
  });
}

TEST_CASE("an exception gives the rounding mode back") {
  in_every_mode([] {
    bool caught = false;
    try {
      round_upward([] { throw std::runtime_error("from within"); });
    } catch (const std::runtime_error&) {
      caught = true;
    }
    if (!caught) throw std::logic_error("it was swallowed");
    try {
      const Upward upward;
      throw std::runtime_error("from within");
    } catch (const std::runtime_error&) {
    }
  });
}

TEST_CASE("boxes give the rounding mode back, and do not depend on it") {
  Boxes boxes(sine_and_root());
  const std::array<Bounds, 4> in{Bounds{0.1, 0.7}, Bounds{-1, 1}, Bounds{3, 3}, Bounds{0.5, 2}};  // two boxes: of x, then of y
  std::array<Bounds, 4> first{};
  boxes.run(2, in.data(), first.data());
  CHECK(first[0].bounded());
  CHECK_FALSE(first[3].bounded());
  in_every_mode([&] {
    std::array<Bounds, 4> out{};
    boxes.run(2, in.data(), out.data());
    if (out != first) throw std::logic_error("other bounds");
    Boxes made(sine_and_root());
    Boxes moved = std::move(made);
  });
}

#if defined(__SSE2__)
TEST_CASE("numbers below 2^-1022 count within, though a library may have switched them off, and stay as they were outside") {
  const unsigned before = _mm_getcsr();
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  volatile double small = 0x1p-1022, half = 0.5;
  const double outside = small * half;
  double within = 0;
  {
    const Upward upward;
    within = small * half;
  }
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  CHECK(outside == 0);
  CHECK(within == 0x1p-1023);
  CHECK((after & 0x8040U) == 0x8040U);
}
#endif
