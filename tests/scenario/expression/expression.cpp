#include <catch2/catch.hpp>
#include <cmath>
#include <core/scenario/expression/expression.hpp>
#include <functional>
#include <random>

using namespace pmreport;
using namespace pmreport::scenario;

namespace {

using Real = long double;
constexpr Real long_pi = 3.141592653589793238462643383279502884L;
constexpr Dimension plain{}, a_length{1, 0, 0, 0}, angle{0, 0, 0, 1};

double constant(const char* text) { return Expression::parse(text, Time::forbidden).at(0).value; }

struct Refusal {
  std::string message;
  std::size_t offset;
};
Refusal refusal(const std::string& text, Time time = Time::allowed) {
  try {
    (void)Expression::parse(text, time);
  } catch (const ExpressionError& e) {
    return {e.what(), e.offset};
  }
  return {"", std::string::npos};
}

// Central differences of fourth order in extended precision. With h = 1e-3 s their own error is about h^4 f''''' / 30 and eps / h^2, 1e-12
// of a function that changes over seconds.
constexpr Real h = 1e-3L;
using Function = std::function<Real(Real)>;
Real rate(const Function& f, Real t) { return (8 * (f(t + h) - f(t - h)) - (f(t + 2 * h) - f(t - 2 * h))) / (12 * h); }
Real acceleration(const Function& f, Real t) {
  return (16 * (f(t + h) + f(t - h)) - (f(t + 2 * h) + f(t - 2 * h)) - 30 * f(t)) / (12 * h * h);
}

}  // namespace

TEST_CASE("units bind tighter than operators, compound ones as a whole") {
  CHECK(constant("5 mm/s") == Approx(0.005));
  CHECK(constant("1 m / 5 mm/s") == Approx(200));
  CHECK(constant("10 N*mm") == Approx(0.01));
  CHECK(constant("(1 + 1) mm") == Approx(0.002));
  CHECK(constant("2 mm^2") == Approx(2e-6));
  CHECK(constant("(2 mm)^2") == Approx(4e-6));
  CHECK(constant("20 mm * sin(30 deg)") == Approx(0.01));
  CHECK(constant("-2^2") == -4);
  CHECK(constant("2^3^2") == 512);
  CHECK(constant("2*3 m") == 6);
  CHECK(constant("6 m/2") == 3);
  CHECK(constant("1 h + 1 min + 1 s") == 3661);
  CHECK(constant("min(2 m, 30 cm)") == Approx(0.3));
  CHECK(constant("3 t") == 3000);
  CHECK(constant("90°") == Approx(double(long_pi / 2)));
  CHECK(constant("1e2mm") == Approx(0.1));
  CHECK(constant("- - 5") == 5);
  CHECK(constant("50 %") == Approx(0.5));
  CHECK(constant("60 rpm") == Approx(double(2 * long_pi)));
  CHECK(constant("8 m^-1 * 2 m") == 16);
  CHECK(constant("sqrt(9 mm^2)") == Approx(0.003));
  CHECK(Expression::parse("t/10 s", Time::allowed).at(5).value == Approx(0.5));
}

TEST_CASE("an expression knows its dimension") {
  const std::pair<const char*, Dimension> cases[] = {
      {"20 mm * sin(2*pi*t/10 s)", a_length},
      {"3 deg * (1 - cos(2*pi*t/10 s))", angle},
      {"3 deg/s^2 * t^2", angle},
      {"10 rpm * t", angle},
      {"2 Hz * t", plain},
      {"sqrt(4 m^2)", a_length},
      {"atan2(1 mm, 2 m)", angle},
      {"acos(0.5)", angle},
      {"step5(t, 1 s, 2 s) * 5 mm", a_length},
      {"9.81 m/s^2", {1, 0, -2, 0}},
      {"10 N * 2 m", {2, 1, -2, 0}},
      {"100 N/mm", {0, 1, -2, 0}},
      {"max(1 mm, abs(-2 mm))", a_length},
      {"exp(-t/1 s)", plain},
      {"m", a_length},
      {"t", {0, 0, 1, 0}},
  };
  for (const auto& [text, dimension] : cases) {
    CAPTURE(text);
    CHECK(Expression::parse(text, Time::allowed).dimension() == dimension);
  }
}

TEST_CASE("rates and accelerations are exact") {
  const std::pair<const char*, Function> cases[] = {
      {"20 mm * sin(2*pi*t/10 s)", [](Real t) { return 0.020L * std::sin(2 * long_pi * t / 10); }},
      {"3 deg * (1 - cos(2*pi*t/10 s))", [](Real t) { return 3 * long_pi / 180 * (1 - std::cos(2 * long_pi * t / 10)); }},
      {"5 mm/s * t + 3 mm/s^2 * t^2 - 1 mm", [](Real t) { return 0.005L * t + 0.003L * t * t - 0.001L; }},
      {"exp(-t/2 s) * log(1 + t/1 s)", [](Real t) { return std::exp(-t / 2) * std::log(1 + t); }},
      {"sqrt(1 + (t/1 s)^3)", [](Real t) { return std::sqrt(1 + t * t * t); }},
      {"atan(t/1 s) / atan2(t, 2 s)", [](Real t) { return std::atan(t) / std::atan2(t, Real(2)); }},
      {"asin(t/10 s) + acos(t/20 s)", [](Real t) { return std::asin(t / 10) + std::acos(t / 20); }},
      {"sinh(t/3 s) * cosh(t/4 s) - tanh(t/1 s)", [](Real t) { return std::sinh(t / 3) * std::cosh(t / 4) - std::tanh(t); }},
      {"tan(t/4 s)^2", [](Real t) { return std::tan(t / 4) * std::tan(t / 4); }},
      {"(1 + t/1 s)^-1.5", [](Real t) { return std::pow(1 + t, -1.5L); }},
      {"-abs(sin(t/1 s) - 2)", [](Real t) { return -std::abs(std::sin(t) - 2); }},
      {"max(t/1 s, 100) + min(t^2/1 s^2, 1000)", [](Real t) { return 100 + t * t; }},
      {"10*step5(t, -1 s, 6 s)",
       [](Real t) {
         const Real u = (t + 1) / 7;
         return 10 * (10 * std::pow(u, 3) - 15 * std::pow(u, 4) + 6 * std::pow(u, 5));
       }},
  };
  std::mt19937 generator(20240);
  std::uniform_real_distribution<double> times(0.3, 5.5);
  for (const auto& [text, f] : cases) {
    const Expression expression = Expression::parse(text, Time::allowed);
    for (int i = 0; i < 50; ++i) {
      const double t = times(generator);
      CAPTURE(text, t);
      const Jet<double> x = expression.at(t);
      const double scale = 1 + std::abs(double(f(t)));
      CHECK(x.value == Approx(double(f(t))).margin(1e-14 * scale));       // a dozen roundings
      CHECK(x.rate == Approx(double(rate(f, t))).margin(1e-10 * scale));  // the differences' own error, see above
      CHECK(x.acceleration == Approx(double(acceleration(f, t))).margin(1e-9 * scale));
    }
  }
}

TEST_CASE("powers are exact at zero") {
  const auto at_zero = [](const char* text) { return Expression::parse(text, Time::allowed).at(0); };
  CHECK(at_zero("t^2").acceleration == 2);
  CHECK(at_zero("t^1").rate == 1);
  CHECK(at_zero("t^1").acceleration == 0);
  CHECK(at_zero("(t/1 s)^0").value == 1);
  CHECK(at_zero("(t/1 s)^0").rate == 0);
}

TEST_CASE("step5 is at rest where it starts and ends") {
  const Expression step = Expression::parse("step5(t, 2 s, 4 s)", Time::allowed);
  for (const double t : {0.0, 2.0, 4.0, 7.0}) {
    CAPTURE(t);
    CHECK(step.at(t).value == (t < 3 ? 0 : 1));
    CHECK(step.at(t).rate == 0);
    CHECK(step.at(t).acceleration == 0);
  }
  CHECK(step.at(3).value == Approx(0.5));
}

TEST_CASE("what has no value is not finite") {
  for (const char* text :
       {"1/0", "sqrt(0-1)", "log(0)", "asin(2)", "0^-1", "1e308*1e308", "max(0, sqrt(-1))", "min(sqrt(-1), 0)", "step5(1, 2, 2) / 0"}) {
    CAPTURE(text);
    CHECK_FALSE(std::isfinite(constant(text)));
  }
}

TEST_CASE("a mistake is told with its place") {
  struct Case {
    const char* text;
    const char* message;
    std::size_t offset;
  };
  const Case cases[] = {
      {"", "expected a quantity, seen an empty text", 0},
      {"   ", "expected a quantity, seen an empty text", 0},
      {"5 mm + 3 deg", "cannot add a length and an angle", 7},
      {"1 - t", "cannot subtract a time from a plain number", 4},
      {"sin(5 mm)", "sin takes an angle or a plain number, seen a length", 4},
      {"exp(5 deg)", "exp takes a plain number, seen an angle", 4},
      {"asin(t)", "asin takes a plain number, seen a time", 5},
      {"max(1 mm, 2)", "max compares like with like: expected a length as before, seen a plain number", 10},
      {"atan2(1)", "atan2 takes 2 arguments, seen 1", 0},
      {"2^t", "expected a plain number as the exponent, seen a time", 2},
      {"2^(t/1 s)", "expected a constant exponent, seen one that depends on t", 2},
      {"t^0.5", "expected a whole number as the exponent of a time, seen 0.5", 2},
      {"sqrt(2 mm)", "expected a square under the root, seen a length", 5},
      {"5 mmm", "unknown unit \"mmm\"; did you mean \"mm\"?", 2},
      {"12 furlong", "unknown unit \"furlong\"", 3},
      {"(1 + 2) parsec", "unknown unit \"parsec\"; did you mean \"arcsec\"?", 8},
      {"2 pi", "expected an operator (+ - * / ^) or the end, seen \"pi\"", 2},
      {"5 m2", "unknown unit \"m2\"; did you mean \"m^2\"?", 2},
      {"5 mm mm", "expected an operator (+ - * / ^) or the end, seen \"mm\"", 5},
      {"mmm", "unknown unit or name \"mmm\"; did you mean \"mm\"?", 0},
      {"sni(t)", "unknown function \"sni\"; did you mean \"sin\"?", 0},
      {"sin", "expected \"(\" after the function sin", 0},
      {"(5 mm", "expected \")\" for the \"(\" at character 1, seen the end", 5},
      {"5 mm)", "expected an operator (+ - * / ^) or the end, seen \")\"", 4},
      {"5 *", "expected a number, a unit or a function, seen the end", 3},
      {"0,5 mm", "expected a number with one decimal point, seen \",\"", 1},
      {"1.2.3", "expected a number with one decimal point, seen \".\"", 3},
      {".", "expected a number, seen \".\"", 0},
      {"nan", "expected a finite number, seen nan", 0},
      {"5 * inf", "expected a finite number, seen inf", 4},
      {"1e999", "a number beyond the range of numbers", 0},
      {"5 m^1.5", "expected a whole number as the exponent of m", 4},
      {"5 $", "expected an operator (+ - * / ^) or the end, seen \"$\"", 2},
      {"(5 m^9)^9", "a dimension beyond all that is physical: m^81", 0},
  };
  for (const Case& c : cases) {
    CAPTURE(c.text);
    const Refusal r = refusal(c.text);
    CHECK(r.message == c.message);
    CHECK(r.offset == c.offset);
  }
}

TEST_CASE("a constant may not depend on time") {
  const Refusal r = refusal("5 mm/s * (t)", Time::forbidden);
  CHECK(r.message == "expected a constant quantity, seen one that depends on t");
  CHECK(r.offset == 10);
}

TEST_CASE("no expression is too deep or too long to be refused") {
  CHECK(refusal(std::string(1000, '(')).message == "expected at most 100 nested parts");
  CHECK(refusal(std::string(1500, '-') + "1").message == "expected at most 100 nested parts");
  CHECK(refusal(std::string(100000, '1')).message == "expected at most 2000 characters, seen 100000");
  std::string tower = "1";
  for (int i = 0; i < 500; ++i) tower += "^1";
  CHECK(refusal(tower).message == "expected at most 100 nested parts");
  std::string flat = "1";
  for (int i = 0; i < 900; ++i) flat += "+1";
  CHECK(Expression::parse(flat, Time::forbidden).at(0).value == 901);
}
