// What intervals say, and when they say nothing. That they hold what they must is judged by other programs: tests/judges/intervals.
#include <catch2/catch.hpp>
#include <core/numbers.hpp>
#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>
#include <cstdint>
#include <functional>
#include <pmreport/jet.hpp>
#include <pmreport/partials.hpp>
#include <random>
#include <vector>

using namespace pmreport;
using namespace pmreport::program;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double least = std::numeric_limits<double>::denorm_min(), greatest = std::numeric_limits<double>::max();

// Of f() with rounding upward.
template <class F>
Bounds of(F&& f) {
  return round_upward([&] { return Interval(f()).bounds(); });
}

struct Named {
  const char* name;
  std::function<Interval(const Interval&)> f;
};
const std::vector<Named> of_one{
    {"-x", [](const Interval& x) { return -x; }},
    {"x + 1", [](const Interval& x) { return x + 1.0; }},
    {"1 - x", [](const Interval& x) { return 1.0 - x; }},
    {"0 x", [](const Interval& x) { return 0.0 * x; }},
    {"-2 x", [](const Interval& x) { return x * -2.0; }},
    {"x / 2", [](const Interval& x) { return x / 2.0; }},
    {"1 / x", [](const Interval& x) { return 1.0 / x; }},
    {"square", [](const Interval& x) { return square(x); }},
    {"sqrt", [](const Interval& x) { return sqrt(x); }},
    {"sin", [](const Interval& x) { return sin(x); }},
    {"cos", [](const Interval& x) { return cos(x); }},
    {"tan", [](const Interval& x) { return tan(x); }},
    {"asin", [](const Interval& x) { return asin(x); }},
    {"acos", [](const Interval& x) { return acos(x); }},
    {"atan", [](const Interval& x) { return atan(x); }},
    {"abs", [](const Interval& x) { return abs(x); }},
    {"exp", [](const Interval& x) { return exp(x); }},
    {"log", [](const Interval& x) { return log(x); }},
    {"sinh", [](const Interval& x) { return sinh(x); }},
    {"cosh", [](const Interval& x) { return cosh(x); }},
    {"tanh", [](const Interval& x) { return tanh(x); }},
    {"x^0", [](const Interval& x) { return pow(x, 0); }},
    {"x^1", [](const Interval& x) { return pow(x, 1); }},
    {"x^2", [](const Interval& x) { return pow(x, 2); }},
    {"x^3", [](const Interval& x) { return pow(x, 3); }},
    {"x^-1", [](const Interval& x) { return pow(x, -1); }},
    {"x^0.5", [](const Interval& x) { return pow(x, 0.5); }},
};
struct NamedOfTwo {
  const char* name;
  std::function<Interval(const Interval&, const Interval&)> f;
};
const std::vector<NamedOfTwo> of_two{
    {"x + y", [](const Interval& x, const Interval& y) { return x + y; }},
    {"x - y", [](const Interval& x, const Interval& y) { return x - y; }},
    {"x y", [](const Interval& x, const Interval& y) { return x * y; }},
    {"x / y", [](const Interval& x, const Interval& y) { return x / y; }},
    {"atan2", [](const Interval& x, const Interval& y) { return atan2(x, y); }},
    {"hypot", [](const Interval& x, const Interval& y) { return hypot(x, y); }},
    {"smaller", [](const Interval& x, const Interval& y) { return smaller(x, y); }},
    {"larger", [](const Interval& x, const Interval& y) { return larger(x, y); }},
    {"hull", [](const Interval& x, const Interval& y) { return hull(x, y); }},
    {"choose", [](const Interval& x, const Interval& y) { return choose(x < y, x, y); }},
};
const std::vector<Interval> nothing_known{Interval::unbounded(),
                                          Interval::of_ends(infinity, 1),
                                          Interval::of_ends(-1, infinity),
                                          Interval::of_ends(0, infinity),
                                          Interval(infinity),
                                          Interval(no_number)};
const std::vector<Interval> something_known{Interval(0.0),        Interval(-0.0),      Interval(1.0),
                                            Interval(-1.0),       Interval(-1.0, 2.0), Interval(0.0, 0.5),
                                            Interval(-3.0, -0.0), Interval(least),     Interval(-greatest, greatest)};

}  // namespace

TEST_CASE("what is not bounded says nothing, and nothing follows from it") {
  for (const Interval& x : nothing_known) {
    for (const Named& f : of_one) {
      CAPTURE(f.name, x.low(), x.high);
      CHECK(of([&] { return f.f(x); }) == Bounds{});
    }
    for (const NamedOfTwo& f : of_two)
      for (const auto* others : {&something_known, &nothing_known})
        for (const Interval& y : *others) {
          CAPTURE(f.name, x.low(), x.high, y.low(), y.high);
          CHECK(of([&] { return f.f(x, y); }) == Bounds{});
          CHECK(of([&] { return f.f(y, x); }) == Bounds{});
        }
    CHECK(x.contains(7));
    CHECK(x.bounds() == Bounds{});
  }
}

// Ends of all kinds and sizes: whatever they are, comparisons with NaN fail.
TEST_CASE("no NaN ever comes out") {
  std::mt19937_64 random(11);
  const std::vector<double> ends{0.0,  -0.0,  least,    -least,    1.0,      -1.0,      pi,        -pi,   pi / 2, 1e-300,
                                 1e10, 1e300, greatest, -greatest, infinity, -infinity, no_number, 710.0, -750.0, 0.5};
  const auto any = [&] { return ends[random() % ends.size()]; };
  const auto is_sound = [](const Interval& x) { return x.negative_low > -infinity && x.high > -infinity && x.low() <= x.high; };
  for (int i = 0; i < 20000; ++i) {
    const Interval x = round_upward([&] { return Interval(any(), any()); }), y = round_upward([&] { return Interval(any(), any()); });
    const auto check = [&](const char* name, const Interval& r) {
      if (!is_sound(r))
        FAIL(name << " of " << x.low() << " " << x.high << ", " << y.low() << " " << y.high << ": " << r.low() << " " << r.high);
    };
    for (const Named& f : of_one) check(f.name, round_upward([&] { return f.f(x); }));
    for (const NamedOfTwo& f : of_two) check(f.name, round_upward([&] { return f.f(x, y); }));
  }
}

TEST_CASE("a function has no bounds where it has no value") {
  CHECK(of([] { return Interval(1.0, 2.0) / Interval(0.0, 1.0); }) == Bounds{});
  CHECK(of([] { return Interval(1.0, 2.0) / Interval(-1.0, -0.0); }) == Bounds{});
  CHECK(of([] { return Interval(0.0) / Interval(0.0); }) == Bounds{});
  CHECK(of([] { return Interval(1.0, 2.0) / 0.0; }) == Bounds{});
  CHECK(of([] { return sqrt(Interval(-least, 1.0)); }) == Bounds{});
  CHECK(of([] { return asin(Interval(0.0, std::nextafter(1.0, 2.0))); }) == Bounds{});
  CHECK(of([] { return acos(Interval(-std::nextafter(1.0, 2.0), 0.0)); }) == Bounds{});
  CHECK(of([] { return log(Interval(0.0, 1.0)); }) == Bounds{});
  CHECK(of([] { return tan(Interval(1.5, 1.6)); }) == Bounds{});
  CHECK(of([] { return tan(Interval(0.0, 100.0)); }) == Bounds{});
  CHECK(of([] { return atan2(Interval(-1.0, 1.0), Interval(-1.0, 1.0)); }) == Bounds{});
  CHECK(of([] { return atan2(Interval(0.0), Interval(0.0, 1.0)); }) == Bounds{});
  CHECK(of([] { return pow(Interval(-1.0, 1.0), -1); }) == Bounds{});
  CHECK(of([] { return pow(Interval(-1.0, 1.0), 0.5); }) == Bounds{});
  CHECK(of([] { return exp(Interval(0.0, 710.0)); }) == Bounds{});
  CHECK(of([] { return Interval(greatest) + 1.0; }) == Bounds{});
}

TEST_CASE("up to the edge of where it has one there are bounds") {
  CHECK(of([] { return sqrt(Interval(0.0, 4.0)); }) == Bounds{0, 2});
  CHECK(of([] { return sqrt(Interval(-0.0, 4.0)); }) == Bounds{0, 2});
  CHECK(of([] { return asin(Interval(-1.0, 1.0)); }).bounded());
  CHECK(of([] { return acos(Interval(-1.0, 1.0)); }).low == 0);
  CHECK(of([] { return log(Interval(least, 1.0)); }).high == 0);
  CHECK(of([] { return pow(Interval(0.0, 4.0), 0.5); }).bounded());
  CHECK(of([] { return pow(Interval(-2.0, 3.0), 3); }).bounded());
  CHECK(of([] { return pow(Interval(-2.0, -1.0), -3); }).bounded());
}

TEST_CASE("exact results stay points") {
  CHECK(of([] { return Interval(1.5) + Interval(2.25); }) == Bounds::exactly(3.75));
  CHECK(of([] { return Interval(1.5) * Interval(-2.0); }) == Bounds::exactly(-3));
  CHECK(of([] { return Interval(3.0) / Interval(-2.0); }) == Bounds::exactly(-1.5));
  CHECK(of([] { return sqrt(Interval(2.25)); }) == Bounds::exactly(1.5));
  CHECK(of([] { return square(Interval(-1.5)); }) == Bounds::exactly(2.25));
  CHECK(of([] { return hypot(Interval(3.0), Interval(-4.0)); }) == Bounds::exactly(5));
  for (const char* zero_at_zero : {"sin", "tan", "asin", "atan", "sinh", "tanh"})
    for (const Named& f : of_one)
      if (f.name == std::string(zero_at_zero)) CHECK(of([&] { return f.f(Interval(-0.0)); }) == Bounds::exactly(0));
  CHECK(of([] { return exp(Interval(0.0)); }) == Bounds::exactly(1));
  CHECK(of([] { return log(Interval(1.0)); }) == Bounds::exactly(0));
}

TEST_CASE("what is inexact lies between two neighbours") {
  const Bounds third = of([] { return 1.0 / Interval(3.0); });
  CHECK(third.high == std::nextafter(third.low, 1.0));
  const Bounds root = of([] { return sqrt(Interval(2.0)); });
  CHECK(root.high == std::nextafter(root.low, 2.0));
  const Bounds tenths = of([] { return Interval(0.1) + 0.2; });
  CHECK(tenths.high == std::nextafter(tenths.low, 1.0));
  const Bounds tiny = of([] { return Interval(least) * 0.5; });
  CHECK(tiny == Bounds{0, least});
  const Bounds root_of_tiny = of([] { return sqrt(Interval(3 * least)); });
  CHECK(root_of_tiny.high == std::nextafter(root_of_tiny.low, 1.0));
}

TEST_CASE("a square, a magnitude, a minimum see that both operands are one number") {
  CHECK(of([] { return square(Interval(-1.0, 2.0)); }) == Bounds{0, 4});
  CHECK(of([] { return abs(Interval(-1.0, 2.0)); }) == Bounds{0, 2});
  CHECK(of([] { return abs(Interval(-2.0, -1.0)); }) == Bounds{1, 2});
  CHECK(of([] { return smaller(Interval(0.0, 3.0), Interval(1.0, 2.0)); }) == Bounds{0, 2});
  CHECK(of([] { return larger(Interval(0.0, 3.0), 1.0); }) == Bounds{1, 3});
  CHECK(of([] { return smaller(1.0, Interval(0.0, 3.0)); }) == Bounds{0, 1});
}

TEST_CASE("waves have their extremes, and no more") {
  CHECK(of([] { return sin(Interval(0.0, 2 * pi)); }) == Bounds{-1, 1});
  CHECK(of([] { return cos(Interval(-100.0, 1e6)); }) == Bounds{-1, 1});
  CHECK(of([] { return sin(Interval(1e300)); }) == Bounds{-1, 1});
  CHECK(of([] { return sin(Interval(1.0, 2.0)); }).high == 1);
  CHECK(of([] { return cos(Interval(3.0, 3.5)); }).low == -1);
  CHECK(of([] { return cos(Interval(-0.5, 0.5)); }).high == 1);
  CHECK(of([] { return sin(Interval(0.0, 1.5)); }).high < 1);
  CHECK(of([] { return sin(Interval(1.0, 2.0)); }).low > 0.84);
  // The largest angle that is looked at.
  CHECK(of([] { return sin(Interval(0x1p20)); }).width() < 2e-15);
}

TEST_CASE("an angle on the cut may be anything: beside it, it is sharp") {
  const Bounds on = of([] { return atan2(Interval(0.0, 1.0), Interval(-2.0, -1.0)); });
  CHECK(on.low < -pi);
  CHECK(on.high > pi);
  CHECK(on.width() == Approx(2 * pi));
  const Bounds above = of([] { return atan2(Interval(least, 1.0), Interval(-2.0, -1.0)); });
  CHECK(above.low == Approx(0.75 * pi));
  CHECK(above.high >= pi);
  const Bounds below = of([] { return atan2(Interval(-1.0, -least), Interval(-2.0, 1.0)); });
  CHECK(below.low <= -pi);
  CHECK(below.high < 1e-300);
  CHECK(of([] { return atan2(Interval(-1.0, 1.0), Interval(least, 1.0)); }).high == Approx(pi / 2));
  CHECK(of([] { return atan2(Interval(0.0), Interval(1.0, 2.0)); }) == Bounds::exactly(0));
}

TEST_CASE("a comparison is certain or open, and logic keeps what is certain") {
  const auto told = [](const Interval::Mask& m) { return m.yes ? 'y' : m.no ? 'n' : '?'; };
  const Interval low(0.0, 1.0), touching(1.0, 2.0), high(3.0, 4.0), all(0.0, 5.0);
  CHECK(told(low < high) == 'y');
  CHECK(told(high < low) == 'n');
  CHECK(told(touching < low) == 'n');  // one is not less than one
  CHECK(told(low < touching) == '?');
  CHECK(told(low < all) == '?');
  CHECK(told(low > high) == 'n');
  CHECK(told(low < 2.0) == 'y');
  CHECK(told(Interval::unbounded() < high) == '?');
  CHECK(told(Interval::of_ends(infinity, 1) < high) == '?');

  const Interval::Mask yes = low < high, no = high < low, open = low < all;
  for (const auto& [a, b] : {std::pair(yes, yes), {yes, no}, {yes, open}, {no, no}, {no, open}, {open, open}}) {
    const char both = told(a) == 'n' || told(b) == 'n' ? 'n' : told(a) == 'y' && told(b) == 'y' ? 'y' : '?';
    const char either = told(a) == 'y' || told(b) == 'y' ? 'y' : told(a) == 'n' && told(b) == 'n' ? 'n' : '?';
    CHECK(told(a && b) == both);
    CHECK(told(b && a) == both);
    CHECK(told(a || b) == either);
    CHECK(told(b || a) == either);
  }
  CHECK(told(!yes) == 'n');
  CHECK(told(!no) == 'y');
  CHECK(told(!open) == '?');
  CHECK(of([&] { return choose(yes, low, high); }) == Bounds{0, 1});
  CHECK(of([&] { return choose(no, low, high); }) == Bounds{3, 4});
  CHECK(of([&] { return choose(open, low, high); }) == Bounds{0, 4});
  CHECK(of([&] { return choose(yes, low, Interval::unbounded()); }) == Bounds{0, 1});  // it is not asked for
  CHECK(of([&] { return choose(open, low, Interval::unbounded()); }) == Bounds{});
}

TEST_CASE("of two enclosures of a number both are right") {
  CHECK(of([] { return common(Interval(0.0, 2.0), Interval(1.0, 3.0)); }) == Bounds{1, 2});
  CHECK(of([] { return common(Interval::unbounded(), Interval(1.0, 3.0)); }) == Bounds{1, 3});
  CHECK(of([] { return common(Interval(1.0, 3.0), Interval::of_ends(infinity, 2)); }) == Bounds{1, 3});
  CHECK(of([] { return common(Interval::unbounded(), Interval::unbounded()); }) == Bounds{});
}

TEST_CASE("bounds become an interval and come back: those of no number are not bounded") {
  for (const Bounds b : {Bounds{-1, 2}, Bounds{0, 0}, Bounds{-greatest, greatest}, Bounds{least, least}})
    CHECK(of([&] { return Interval(b); }) == b);
  for (const Bounds b :
       {Bounds{}, Bounds{2, 1}, Bounds{no_number, 1}, Bounds{1, no_number}, Bounds{-infinity, 1}, Bounds{infinity, infinity}})
    CHECK(of([&] { return Interval(b); }) == Bounds{});
}

TEST_CASE("width, magnitude and middle of an interval") {
  const Interval x(-3.0, 1.0);
  CHECK(round_upward([&] { return x.width(); }) == 4);
  CHECK(x.magnitude() == 3);
  CHECK(x.mignitude() == 0);
  CHECK(Interval(-3.0, -2.0).mignitude() == 2);
  for (const Interval& y : {x, Interval(greatest), Interval(-greatest, greatest), Interval(least), Interval(least, 2 * least)}) {
    const double middle = round_upward([&] { return y.middle(); });
    CHECK(y.low() <= middle);
    CHECK(middle <= y.high);
  }
}

TEST_CASE("jets and partials of intervals hold those of the numbers in them") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> symmetric(-1, 1), share(0, 1);
  const auto f = [](const auto& x, const auto& y) {
    return atan2(sin(x) * y + 2.0, sqrt(x * x + 3.0)) / (cos(y) + 1.5) + abs(y) * smaller(x, y);
  };
  for (int i = 0; i < 2000; ++i) {
    const double width = std::exp2(-20 * share(random)), low[] = {symmetric(random), symmetric(random)};
    const Interval x(low[0], low[0] + width), y(low[1], low[1] + width);
    const auto jet = round_upward([&] { return f(Jet<Interval>(x, 1.0, -0.5), Jet<Interval>(y, -2.0, 0.25)); });
    const auto partials = round_upward([&] { return f(Partials<Interval, 2>::variable(x, 0), Partials<Interval, 2>::variable(y, 1)); });
    const double at[] = {x.low() + share(random) * width, y.low() + share(random) * width};
    const auto jet_at = f(Jet<long double>(at[0], 1.0L, -0.5L), Jet<long double>(at[1], -2.0L, 0.25L));
    const auto partials_at = f(Partials<long double, 2>::variable(at[0], 0), Partials<long double, 2>::variable(at[1], 1));
    // Extended precision errs by some 1e-18 here, which no interval is as narrow as.
    const auto holds = [](const Interval& all, long double one) { return all.bounded() && all.low() <= one && one <= all.high; };
    CAPTURE(i, x.low(), x.high, y.low(), y.high);
    CHECK(holds(jet.value, jet_at.value));
    CHECK(holds(jet.rate, jet_at.rate));
    CHECK(holds(jet.acceleration, jet_at.acceleration));
    for (std::size_t k = 0; k < 2; ++k) CHECK(holds(partials.partial[k], partials_at.partial[k]));
  }
}

TEST_CASE("intervals go through Eigen's products") {
  const Eigen::Matrix<Interval, 3, 1> v(Interval(1.0, 2.0), Interval(-1.0), Interval(0.0, 0.5));
  Eigen::Matrix3d turn;
  turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const auto turned = round_upward([&] { return Eigen::Matrix<Interval, 3, 1>(turn * v); });
  CHECK(turned(0).bounds() == Bounds{1, 1});
  CHECK(turned(1).bounds() == Bounds{1, 2});
  CHECK(round_upward([&] { return v.dot(v); }).bounds() == Bounds{2, 5.25});
}
