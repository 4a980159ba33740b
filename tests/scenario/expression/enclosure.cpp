// What an expression can be over a span of time, against jets in extended precision at instants of it.
#include <catch2/catch.hpp>
#include <core/scenario/expression/behaviour.hpp>
#include <core/scenario/expression/enclosure.hpp>
#include <filesystem>
#include <fstream>
#include <tests/scenario/enclosed.hpp>

using namespace pmreport;
using namespace pmreport::scenario;
using namespace enclosed;

namespace {

using J = Jet<Real>;

Expression parsed_text(const std::string& text) { return Expression::parse(text, Time::allowed); }

J power(const J& x, Real n) {
  const Real df = n == 0 ? 0 : n * std::pow(x.value, n - 1), ddf = n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(x.value, n - 2);
  return chain(x, std::pow(x.value, n), df, ddf);
}
J step(const J& x, const J& from, const J& to) {
  const J u = (x - from) / (to - from);
  if (u.value <= 0 || u.value >= 1) return {u.value <= 0 ? 0.0L : 1.0L, 0.0L, 0.0L};
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

// By the rules of school, one term after the other.
J evaluated(std::span<const Term> terms, Real t) {
  std::vector<J> x;
  for (const Term& term : terms) {
    const auto of = [&](int i) { return i < 0 ? J() : x[static_cast<std::size_t>(i)]; };
    const J a = of(term.a), b = of(term.b);
    const Real v = a.value;
    x.push_back([&]() -> J {
      switch (term.operation) {
        case Operation::constant:
          return {term.constant, 0.0L, 0.0L};
        case Operation::time:
          return {t, 1.0L, 0.0L};
        case Operation::variable:
          break;
        case Operation::negate:
          return -a;
        case Operation::add:
          return a + b;
        case Operation::subtract:
          return a - b;
        case Operation::multiply:
          return a * b;
        case Operation::divide:
          return a / b;
        case Operation::power:
          return power(a, term.constant);
        case Operation::sin:
          return chain(a, std::sin(v), std::cos(v), -std::sin(v));
        case Operation::cos:
          return chain(a, std::cos(v), -std::sin(v), -std::cos(v));
        case Operation::tan: {
          const Real y = std::tan(v);
          return chain(a, y, 1 + y * y, 2 * y * (1 + y * y));
        }
        case Operation::asin:
          return chain(a, std::asin(v), 1 / std::sqrt(1 - v * v), v / std::pow(1 - v * v, 1.5L));
        case Operation::acos:
          return chain(a, std::acos(v), -1 / std::sqrt(1 - v * v), -v / std::pow(1 - v * v, 1.5L));
        case Operation::atan:
          return chain(a, std::atan(v), 1 / (1 + v * v), -2 * v / ((1 + v * v) * (1 + v * v)));
        case Operation::atan2: {
          const Real d = v * v + b.value * b.value, rate = (b.value * a.rate - v * b.rate) / d;
          const Real d_rate = 2 * (v * a.rate + b.value * b.rate);
          return {std::atan2(v, b.value), rate, (b.value * a.acceleration - v * b.acceleration - d_rate * rate) / d};
        }
        case Operation::sinh:
          return chain(a, std::sinh(v), std::cosh(v), std::sinh(v));
        case Operation::cosh:
          return chain(a, std::cosh(v), std::sinh(v), std::cosh(v));
        case Operation::tanh: {
          const Real y = std::tanh(v), slope = 1 / (std::cosh(v) * std::cosh(v));
          return chain(a, y, slope, -2 * y * slope);
        }
        case Operation::sqrt:
          return chain(a, std::sqrt(v), 0.5L / std::sqrt(v), -0.25L / (v * std::sqrt(v)));
        case Operation::exp:
          return chain(a, std::exp(v), std::exp(v), std::exp(v));
        case Operation::log:
          return chain(a, std::log(v), 1 / v, -1 / (v * v));
        case Operation::abs:
          return v < 0 ? -a : a;
        case Operation::min:
          return b.value < v || std::isnan(b.value) ? b : a;
        case Operation::max:
          return v < b.value || std::isnan(b.value) ? b : a;
        case Operation::step5:
          return step(a, b, of(term.c));
      }
      return {NAN, NAN, NAN};
    }());
  }
  return x.back();
}
At exact(const Expression& e) {
  return [&e](Real t) { return evaluated(e.terms(), t); };
}
Over bounds_of(const Expression& e) {
  return [&e](Bounds span) { return scenario::over(e, span); };
}

// Texts over all functions and operators.
class Author {
 public:
  explicit Author(unsigned seed) : generator_(seed) {}
  std::string write(int depth) {
    if (depth == 0)
      return pick(4) == 0 ? number(-3, 3) : pick(3) == 0 ? "(" + number(-2, 2) + " + t/1 s)" : "(" + number(0.1, 4) + "*t/1 s)";
    const auto x = [&] { return write(pick(2) == 0 ? 0 : depth - 1); };
    static const char *functions[] = {"sin", "cos", "tan", "sinh", "cosh", "tanh", "sqrt", "exp", "log", "abs"},
                      *angles[] = {"asin", "acos", "atan"};
    switch (pick(12)) {
      case 0:
        return "(" + x() + " + " + x() + ")";
      case 1:
        return "(" + x() + " - " + x() + ")";
      case 2:
        return "(" + x() + " * " + x() + ")";
      case 3:
        return "(" + x() + " / " + x() + ")";
      case 4:
        return "(" + x() + ")^(" + std::vector<std::string>{"2", "3", "-1", "0.5", "1.5", "-2", "2.5", "0", "7"}[pick(9)] + ")";
      case 5:
        return (pick(2) == 0 ? "min(" : "max(") + x() + ", " + x() + ")";
      case 6:
        return "step5(" + x() + ", " + number(-1, 1) + ", " + number(1.1, 3) + ")";
      case 7:
        return "(atan2(" + x() + ", " + x() + ")/1 rad)";
      case 8:
        return "(" + std::string(angles[pick(std::size(angles))]) + "(" + x() + ")/1 rad)";
      default:
        return std::string(functions[pick(std::size(functions))]) + "(" + x() + ")";
    }
  }
  std::mt19937& generator() { return generator_; }

 private:
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(generator_); }
  std::string number(double low, double high) {
    return "(" + std::to_string(std::uniform_real_distribution<double>(low, high)(generator_)) + ")";
  }
  std::mt19937 generator_;
};

// How much wider the bounds are than what the value does, as the instants tell.
double excess(const Expression& e, double low, double high) {
  const Bounds b = scenario::over(e, {low, high}).value;
  Real least = INFINITY, most = -INFINITY;
  for (int i = 0; i <= 2000; ++i) {
    const Real x = evaluated(e.terms(), Real(low) + (Real(high) - Real(low)) * i / 2000).value;
    least = std::min(least, x), most = std::max(most, x);
  }
  return double((Real(b.high) - Real(b.low)) - (most - least));
}

}  // namespace

TEST_CASE("at every instant an expression is within its bounds over the span") {
  constexpr unsigned seed = 20;
  Author author(seed);
  int known = 0, spans = 0;
  for (int i = 0; i < 1500; ++i) {
    const std::string text = author.write(3);
    CAPTURE(seed, i, text);
    const Expression e = parsed_text(text);
    const Escaped out = escaped(bounds_of(e), exact(e), -2, 5, 10, author.generator());
    INFO(out.first);
    REQUIRE(out.instants == 0);
    known += out.spans - out.unbounded, spans += out.spans;
  }
  CHECK(known > spans / 3);  // of random texts: many have no value over half of the time
}

TEST_CASE("bounds that are too narrow are found out") {
  std::mt19937 generator(1);
  const Expression e = parsed_text("abs(sin(3*t/1 s)) * exp(-t/4 s)");
  const auto narrowed = [&](auto&& change) {
    const Over over = [&](Bounds span) {
      Jet<Bounds> x = scenario::over(e, span);
      change(x);
      return x;
    };
    return escaped(over, exact(e), 0, 5, 200, generator).instants;
  };
  CHECK(narrowed([](Jet<Bounds>&) {}) == 0);
  CHECK(narrowed([](Jet<Bounds>& x) { x.value.high -= 0.01 * x.value.width(); }) > 0);
  CHECK(narrowed([](Jet<Bounds>& x) { x.rate.low += 0.01 * x.rate.width(); }) > 0);
  CHECK(narrowed([](Jet<Bounds>& x) { x.acceleration = {-x.acceleration.high, -x.acceleration.low}; }) > 0);
}

TEST_CASE("bounds shrink to what an expression does with the square of the span") {
  for (const char* text : {"sin(2*t/1 s) * cos(3*t/1 s) + t/3 s", "exp(sin(t/1 s)) / (2 + cos(t/1 s))", "(t/1 s)^3 - (t/1 s)^2 * 2 + 1",
                           "atan2(sin(t/1 s) + 2, t/1 s) * tanh(t/1 s)", "log(2 + t/1 s) * (t/1 s)^1.5 - asin(t/9 s)/1 rad"}) {
    CAPTURE(text);
    const Expression e = parsed_text(text);
    for (const double t : {0.7, 1.3, 2.1}) {
      const double wide = excess(e, t, t + 0.02), narrow = excess(e, t, t + 0.01);
      CAPTURE(t, wide, narrow);
      CHECK(wide < 20 * 0.02 * 0.02);      // the second derivatives are no more than 13
      CHECK(narrow < 0.3 * wide + 1e-14);  // a quarter, and what is left of higher orders
    }
  }
}

TEST_CASE("at a point the bounds are some units in the last place") {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> time(0.1, 4);
  const Expression e = parsed_text("20 mm * sin(2*pi*t/10 s) + 3 mm * exp(-t/2 s)");
  for (int i = 0; i < 200; ++i) {
    const Jet<Bounds> x = scenario::over(e, Bounds::exactly(time(generator)));
    CHECK(x.value.width() < 20 * 2.3e-16 * 0.023);  // of the largest term
    CHECK(x.rate.width() < 20 * 2.3e-16 * 0.03);
  }
}

TEST_CASE("a span that holds or touches a switch has both sides of it") {
  const auto check_rate = [](const char* text, Bounds span, Bounds rate) {
    CAPTURE(text, span.low, span.high);
    const Jet<Bounds> x = scenario::over(parsed_text(text), span);
    CHECK(x.rate.low == Approx(rate.low).margin(1e-12));
    CHECK(x.rate.high == Approx(rate.high).margin(1e-12));
  };
  for (const Bounds span : {Bounds{0.5, 2}, {1, 2}, {0.5, 1}, {1, 1}}) {
    check_rate("abs(t/1 s - 1)", span, {-1, 1});
    check_rate("min(t/1 s, 1)", span, {0, 1});
    check_rate("max(2 - t/1 s, 3*t/1 s - 2)", span, {-1, 3});
    check_rate("step5(t, 0 s, 1 s) * 0 + max(0, t/1 s - 1)", span, {0, 1});
  }
  check_rate("abs(t/1 s - 1)", {1.25, 2}, {1, 1});
  // The value of an angle that jumps by a turn, on both sides; what it moves by is not the integral of any rate.
  const Jet<Bounds> turn = scenario::over(parsed_text("atan2(sin(t/1 s), cos(t/1 s))"), {3, 3.2});
  CHECK(turn.value.low < -3.14159);
  CHECK(turn.value.high > 3.14159);
  CHECK_FALSE(turn.rate.bounded());
  CHECK(scenario::over(parsed_text("abs(t/1 s - 1)"), {0.5, 2}).rate.bounded());
  CHECK_FALSE(scenario::over(parsed_text("abs(t/1 s - 1)"), {0.5, 2}).acceleration.bounded());
  CHECK_FALSE(scenario::over(parsed_text("min(t/1 s, 1)"), {0.5, 1}).acceleration.bounded());
  // Begin and end of a step are smooth to the acceleration.
  for (const double t : {0.0, 1.0}) {
    const Jet<Bounds> x = scenario::over(parsed_text("step5(t, 0 s, 1 s)"), {t - 1e-6, t + 1e-6});
    CHECK(x.value.has(t));
    CHECK(x.value.width() < 1e-14);
    CHECK(x.acceleration.width() < 1e-3);
  }
}

TEST_CASE("where an expression explodes nothing is known, and away from it all is") {
  for (const char* text : {"tan(t/1 s)", "1/(t/1 s - 1.5)", "1/sin(2*t/1 s - 3)", "sqrt(t/1 s - 1.5)", "log(t/1 s - 1.5)", "asin(t/1.5 s)",
                           "(t/1 s - 1.5)^-2", "(t/1 s - 1.5)^0.5", "atan2(t/1 s - 1.5, 0*t/1 s)"}) {
    CAPTURE(text);
    const Expression e = parsed_text(text);
    CHECK_FALSE(scenario::over(e, {1.4, 1.6}).value.bounded());
    CHECK_FALSE(scenario::over(e, {-1000, 1000}).acceleration.bounded());
  }
  CHECK(scenario::over(parsed_text("tan(t/1 s)"), {1, 1.5}).acceleration.bounded());
  // At the root of nothing there is a value, but no rate; of its power 1.5 a rate, but no acceleration.
  const Jet<Bounds> root = scenario::over(parsed_text("sqrt(t/1 s)"), {0, 1}), power = scenario::over(parsed_text("(t/1 s)^1.5"), {0, 1});
  CHECK(root.value.bounded());
  CHECK_FALSE(root.rate.bounded());
  CHECK(power.rate.bounded());
  CHECK_FALSE(power.acceleration.bounded());
}

TEST_CASE("no expression of the fuzzer's corpus leaves its bounds") {
  std::mt19937 generator(3);
  int expressions = 0;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(SOURCE) / "tests/fuzz/corpus/expression")) {
    std::ifstream in(entry.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    CAPTURE(text);
    try {
      const Expression e = parsed_text(text);
      ++expressions;
      const Escaped out = escaped(bounds_of(e), exact(e), 0, 10, 20, generator);
      INFO(out.first);
      CHECK(out.instants == 0);
      (void)behaviour(e, 0, 10);
    } catch (const ExpressionError&) {
      continue;
    }
  }
  CHECK(expressions > 3);
}
