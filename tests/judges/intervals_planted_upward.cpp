// Errors planted in the interval type: what is shown of the real one in intervals_upward.cpp, fails of each.
#include <catch2/catch.hpp>
#include <pmreport/jet.hpp>
#include <pmreport/partials.hpp>
#include <tests/judges/interval_checks.hpp>

using namespace pmreport;
using namespace pmreport::judges;
using program::Ends;
using program::Interval;

namespace {

constexpr std::uint64_t seed = 40;
constexpr int tries = 4000;

// The real one, to plant an error in by a friend that is found before its own.
struct Faulty : Interval {
  Faulty(double c) : Interval(c) {}
  Faulty(const Interval& x) : Interval(x) {}
};

struct InwardSum : Faulty {
  using Faulty::Faulty;
  // -(-low) - (-low) rounded upward is the low end rounded upward too.
  friend InwardSum operator+(const InwardSum& x, const InwardSum& y) {
    return Interval::of_ends(-(-x.negative_low - y.negative_low), x.high + y.high);
  }
};

struct ThreeProducts : Faulty {
  using Faulty::Faulty;
  friend ThreeProducts operator*(const ThreeProducts& x, const ThreeProducts& y) {
    const Interval r = Interval(x) * Interval(y);
    return Interval::of_ends(r.negative_low, std::max({x.high * y.high, -x.negative_low * y.high, x.high * -y.negative_low}));
  }
};

struct InwardRoot : Faulty {
  using Faulty::Faulty;
  friend InwardRoot sqrt(const InwardRoot& x) {
    const Interval r = sqrt(Interval(x));
    return r.bounded() ? Interval::of_ends(-std::sqrt(x.low()), r.high) : r;  // rounded upward, as the high end is
  }
};

struct SharpSine : Faulty {
  using Faulty::Faulty;
  friend SharpSine sin(const SharpSine& x) {
    const Ends r = program::ends::sin({x.negative_low, x.high}, 0);
    return Interval::of_ends(r.negative_low, r.high);
  }
};

struct SineOfTheEnds : Faulty {
  using Faulty::Faulty;
  friend SineOfTheEnds sin(const SineOfTheEnds& x) { return hull(sin(Interval(x.low())), sin(Interval(x.high))); }
};

struct RootOfThePositivePart : Faulty {
  using Faulty::Faulty;
  friend RootOfThePositivePart sqrt(const RootOfThePositivePart& x) {
    return sqrt(x.low() < 0 && x.high >= 0 ? Interval(0.0, x.high) : Interval(x));
  }
};

struct HalfAngle : Faulty {
  using Faulty::Faulty;
  // atan(y / x) where the left half plane is forgotten.
  friend HalfAngle atan2(const HalfAngle& y, const HalfAngle& x) { return atan(Interval(y) / Interval(x)); }
};

template <class T>
struct WrongSign : T {
  WrongSign(const T& x) : T(x) {}
  friend WrongSign cos(const WrongSign& x) {
    T r = cos(static_cast<const T&>(x));
    if constexpr (requires { r.partial; })
      r.partial[0] = -r.partial[0];
    else
      r.acceleration = -r.acceleration;
    return r;
  }
};

template <class I>
bool is_caught(const char* operation) {
  return verdict<I>(judged_operation(operation), tries, seed).wrong.has_value();
}

}  // namespace

TEST_CASE("what no error is planted in passes the checks that catch the others") {
  for (const char* operation : {"x + y", "x y", "sqrt", "sin", "atan2"}) CHECK_FALSE(is_caught<Faulty>(operation));
}

TEST_CASE("a sum with one end rounded inward is caught") { CHECK(is_caught<InwardSum>("x + y")); }
TEST_CASE("a product that forgets one pair of ends is caught") { CHECK(is_caught<ThreeProducts>("x y")); }
TEST_CASE("a root with its low end rounded upward is caught") { CHECK(is_caught<InwardRoot>("sqrt")); }
TEST_CASE("a root of a number that may be negative is caught") { CHECK(is_caught<RootOfThePositivePart>("sqrt")); }
TEST_CASE("a sine that is not widened by its error is caught") { CHECK(is_caught<SharpSine>("sin")); }
TEST_CASE("a sine that forgets the extremes between the ends is caught") { CHECK(is_caught<SineOfTheEnds>("sin")); }
TEST_CASE("an angle that forgets the left half plane is caught") { CHECK(is_caught<HalfAngle>("atan2")); }

TEST_CASE("one derivative with the wrong sign is caught in partials and in jets") {
  using P = WrongSign<Partials<Interval, 1>>;
  using J = WrongSign<Jet<Interval>>;
  const JudgedOperation& o = judged_operation("cos");
  const std::pair within(-4.0, 4.0);
  CHECK(wrong_derivative<P>(
      o, 1, within, seed, [](const Interval& x) { return P(Partials<Interval, 1>::variable(x, 0)); },
      [](const P& x) { return x.partial[0]; }));
  CHECK(wrong_derivative<J>(
      o, 2, within, seed, [](const Interval& x) { return J(Jet<Interval>(x, 1.0, 0.0)); }, [](const J& x) { return x.acceleration; }));
}
