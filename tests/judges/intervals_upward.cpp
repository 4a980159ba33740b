// Every operation on intervals before MPFI and FLINT/Arb.
#include <catch2/catch.hpp>
#include <pmreport/jet.hpp>
#include <pmreport/partials.hpp>
#include <tests/judges/interval_checks.hpp>

using namespace pmreport;
using namespace pmreport::judges;
using program::Interval;

namespace {

constexpr std::uint64_t seed = 20;
constexpr int many_sums = 100000, many_functions = 12000;

int how_many(const JudgedOperation& o) { return o.ulps == 0 ? many_sums : many_functions; }

// Where our rules give up and MPFI goes on: tangent beside its poles and far away, the origin of an angle.
bool may_give_up(const std::string& name) { return name == "tan" || name == "atan2"; }

// Of angles MPFI has the cut's upper side alone where the other is not within, and waves beyond the largest angle are not looked at.
bool judged_for_width(const JudgedOperation& o, const Bounds& a, const Bounds& b) {
  if (o.name == std::string("atan2")) return !(a.low <= 0 && a.high >= 0 && b.low <= 0);
  if (o.from == Operands::angle) return std::max(std::abs(a.low), std::abs(a.high)) <= 0x1p20;
  return true;
}

}  // namespace

TEST_CASE("every operation's interval holds the range that MPFI has, and the values that Arb has in it") {
  for (const JudgedOperation& o : judged_operations()) {
    CAPTURE(o.name, seed);
    const Verdict v = verdict<Interval>(o, how_many(o), seed);
    if (v.wrong) FAIL_CHECK(*v.wrong);
    CHECK(v.bounded > how_many(o) / 4);
  }
}

TEST_CASE("no operation's interval is wider than MPFI's best by more than the bound of its error") {
  for (const JudgedOperation& o : judged_operations()) {
    std::mt19937_64 random(seed + 1);
    Judges judges;
    for (int i = 0; i < how_many(o) / 4; ++i) {
      const Bounds a = operand(o.from, random), b = operand(o.from, random);
      if (!judged_for_width(o, a, b)) continue;
      const Bounds answer = round_upward([&] { return ours(o.name, Interval(a), Interval(b)).bounds(); });
      if (!answer.bounded() && may_give_up(o.name)) continue;
      const double excess = judges.excess(o, a, b, answer);
      if (excess <= o.ulps) continue;
      CAPTURE(o.name, seed, i, a.low, a.high, b.low, b.high, answer.low, answer.high);
      CHECK(excess <= o.ulps);
      break;
    }
  }
}

// Around the multiples of pi / 2 that doubles come nearest to, known from the search for the worst cases of reduction, and around others.
TEST_CASE("waves hold their extremes beside every multiple of a quarter turn") {
  Judges judges;
  std::mt19937_64 random(seed);
  for (const char* name : {"sin", "cos", "tan"}) {
    const JudgedOperation& o = judged_operation(name);
    for (int k = -1000; k <= 1000; ++k) {
      const double near = k * (std::numbers::pi / 2);
      for (const double from : {std::nextafter(near, -1e9), near, std::nextafter(near, 1e9)})
        for (const double width : {0.0, 1e-15, 1e-9, 0.1}) {
          const Bounds a{from, from + width};
          const Bounds answer = round_upward([&] { return ours(name, Interval(a), Interval(a)).bounds(); });
          const auto wrong = judges.wrong(o, a, a, answer, random);
          if (wrong) FAIL(*wrong);
        }
    }
  }
}

// The error that the ends are widened by: the library's own, at random arguments and while rounding goes upward, stays below it.
TEST_CASE("the mathematical library errs by less than intervals allow for") {
  using namespace program::ends;
  struct Bound {
    const char* name;
    double (*f)(double);
    double ulps;
  };
  const Bound bounds[] = {
      {"tan", [](double x) { return std::tan(x); }, tangent_ulps},      {"asin", [](double x) { return std::asin(x); }, arc_ulps},
      {"acos", [](double x) { return std::acos(x); }, arc_ulps},        {"atan", [](double x) { return std::atan(x); }, arc_ulps},
      {"exp", [](double x) { return std::exp(x); }, exponential_ulps},  {"log", [](double x) { return std::log(x); }, exponential_ulps},
      {"sinh", [](double x) { return std::sinh(x); }, hyperbolic_ulps}, {"cosh", [](double x) { return std::cosh(x); }, hyperbolic_ulps},
      {"tanh", [](double x) { return std::tanh(x); }, hyperbolic_ulps},
  };
  for (const Bound& f : bounds) {
    const JudgedOperation& o = judged_operation(f.name);
    std::mt19937_64 random(seed + 2);
    Judges judges;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = operand(o.from, random).low;
      const double value = round_upward([&] { return f.f(x); });
      if (std::isfinite(value) && std::abs(value) > 0x1p-1000) worst = std::max(worst, judges.error_of_point(o, x, value));
    }
    CAPTURE(f.name, worst);
    CHECK(worst < f.ulps - 0.4);
  }
}

// Its bound was derived, operation by operation; the arguments that doubles come nearest to zeros with are among the neighbours of k pi
// / 2.
TEST_CASE("our own sine and cosine err by less than their bound, near their zeros too") {
  using namespace program::ends;
  std::mt19937_64 random(seed + 3);
  Judges judges;
  for (const double quarters : {0.0, 1.0}) {
    const JudgedOperation& o = judged_operation(quarters == 0 ? "sin" : "cos");
    double worst = 0, worst_near_zero = 0;
    const auto check = [&](double x) {
      const Approximation of = round_upward([&] { return wave_at(x, quarters, wave_units); });
      const double share = judges.error_of_point(o, x, of.value, of.error);
      if (!(share <= 1)) FAIL(o.name << " at " << x << ": " << share << " of the bound");
      (std::abs(of.value) > 0x1p-20 ? worst : worst_near_zero) = std::max(std::abs(of.value) > 0x1p-20 ? worst : worst_near_zero, share);
    };
    for (int i = 0; i < 60000; ++i)
      if (const double x = operand(o.from, random).low; std::abs(x) <= largest_angle) check(x);
    for (int i = 0; i < 20000; ++i) {
      const double zero = static_cast<double>(random() % 667543) * (std::numbers::pi / 2);
      for (const double x : {std::nextafter(zero, 0.0), zero, std::nextafter(zero, 1e9)}) check(x);
    }
    CAPTURE(o.name, worst, worst_near_zero);
    CHECK(worst > 0.3);  // the bound is not out of all proportion
  }
}

TEST_CASE("partials and jets of intervals hold the derivatives that Arb has") {
  using P = Partials<Interval, 1>;
  using J = Jet<Interval>;
  for (const auto& [name, low, high] : {std::tuple("square", -2.0, 2.0),
                                        {"sqrt", 0.3, 4.0},
                                        {"sin", -4.0, 4.0},
                                        {"cos", -4.0, 4.0},
                                        {"tan", -1.0, 1.0},
                                        {"asin", -0.7, 0.7},
                                        {"acos", -0.7, 0.7},
                                        {"abs", 0.1, 2.0}}) {
    const JudgedOperation& o = judged_operation(name);
    const std::pair within(low, high);
    const auto partial = wrong_derivative<P>(
        o, 1, within, seed, [](const Interval& x) { return P::variable(x, 0); }, [](const P& x) { return x.partial[0]; });
    if (partial) FAIL_CHECK(*partial);
    const auto moving = [](const Interval& x) { return J(x, 1.0, 0.0); };
    if (const auto rate = wrong_derivative<J>(o, 1, within, seed, moving, [](const J& x) { return x.rate; })) FAIL_CHECK(*rate);
    if (const auto second = wrong_derivative<J>(o, 2, within, seed, moving, [](const J& x) { return x.acceleration; })) FAIL_CHECK(*second);
  }
}
