// Programs that differentiate a program, against differences in extended precision and against the scalars that carry derivatives.
#include <tests/recorded_program/recording.hpp>

#include <catch2/catch.hpp>
#include <core/program/derivative.hpp>
#include <core/program/evaluate.hpp>
#include <pmreport/jet.hpp>
#include <pmreport/partials.hpp>

#include <algorithm>
#include <cmath>

using namespace recording;
using functions::Random;

namespace {

// A motion of each input, and its motion at time t.
struct Motion {
  std::vector<double> numbers;  // values, then rates, then accelerations
  std::size_t inputs() const { return numbers.size() / 3; }
  long double at(std::size_t i, long double t) const {
    return numbers[i] + numbers[inputs() + i] * t + numbers[2 * inputs() + i] * t * t / 2;
  }
};

// Largest deviation of a program's numbers from those expected, in terms of the larger of one and the expected number.
double deviation(const Program& p, const std::vector<double>& in, const std::vector<long double>& expected) {
  std::vector<double> out(p.outputs().size());
  REQUIRE(out.size() == expected.size());
  program::Evaluator<double>(p).run(in, out);
  double worst = 0;
  for (std::size_t o = 0; o < out.size(); ++o) {
    const double d = static_cast<double>(std::abs(out[o] - expected[o]) / std::max(1.0L, std::abs(expected[o])));
    if (!(d <= worst)) worst = d;
  }
  return worst;
}

// Values, rates and accelerations of f along the motion, by central differences of the sixth order in extended precision. With this step
// their errors, h^6 of the seventh and eighth derivatives and 1e-19 / h^2 of rounding, stay below 1e-9 for what is tried.
constexpr double difference_tolerance = 1e-8;
template <class F>
std::vector<long double> differences_in_time(F&& f, const Motion& motion) {
  constexpr long double h = 0x1p-9L;
  const auto at = [&](int k) {
    std::vector<long double> x;
    for (std::size_t i = 0; i < motion.inputs(); ++i) x.push_back(motion.at(i, k * h));
    return f(x);
  };
  const std::vector<long double> f0 = at(0), f1 = at(1), b1 = at(-1), f2 = at(2), b2 = at(-2), f3 = at(3), b3 = at(-3);
  const std::size_t n = f0.size();
  std::vector<long double> out = f0;
  for (std::size_t o = 0; o < n; ++o) out.push_back((45 * (f1[o] - b1[o]) - 9 * (f2[o] - b2[o]) + (f3[o] - b3[o])) / (60 * h));
  for (std::size_t o = 0; o < n; ++o)
    out.push_back((270 * (f1[o] + b1[o]) - 27 * (f2[o] + b2[o]) + 2 * (f3[o] + b3[o]) - 490 * f0[o]) / (180 * h * h));
  return out;
}

// The same by Jet, whose rules are written down apart from those of programs.
constexpr double rounding = 1e-12;  // of second derivatives of a dozen operations
template <class F>
std::vector<long double> by_jets(F&& f, const Motion& motion) {
  std::vector<Jet<double>> x;
  const std::size_t n = motion.inputs();
  for (std::size_t i = 0; i < n; ++i) x.emplace_back(motion.numbers[i], motion.numbers[n + i], motion.numbers[2 * n + i]);
  const std::vector<Jet<double>> y = f(x);
  std::vector<long double> out;
  for (const auto& j : y) out.push_back(j.value);
  for (const auto& j : y) out.push_back(j.rate);
  for (const auto& j : y) out.push_back(j.acceleration);
  return out;
}
std::vector<long double> first_order(const std::vector<long double>& all) { return {all.begin(), all.begin() + all.size() / 3 * 2}; }

template <class F>
auto as_vector(F f, std::size_t arguments) {
  return [f, arguments]<class T>(const std::vector<T>& x) {
    if constexpr (std::is_invocable_v<F, const T&>)
      return std::vector<T>{T(f(x[0]))};
    else
      return std::vector<T>{T(f(x[0], x[1]))};
    static_cast<void>(arguments);
  };
}

// Each function by name with a motion within its range.
template <class Visit>
void each_function(Random& random, Visit&& visit) {
  constexpr int tries = 10;
  const auto motion = [&](std::size_t inputs, double min, double max) {
    Motion m;
    for (std::size_t i = 0; i < inputs; ++i) m.numbers.push_back(random.within(min, max));
    for (std::size_t i = 0; i < 2 * inputs; ++i) m.numbers.push_back(random.within(-1, 1));
    return m;
  };
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < tries; ++i) visit(name, recorded_of_one(f), as_vector(f, 1), motion(1, min, max));
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < tries; ++i) visit(name, recorded_of_two(f), as_vector(f, 2), motion(2, min, max));
  });
}

// Not near the kinks of Everything, where differences see both sides.
std::vector<Motion> smooth_motions(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Motion> out;
  while (out.size() < count) {
    Motion m{random_numbers(random, 9, 1)};
    const double x = m.numbers[0], y = m.numbers[1], z = m.numbers[2], s = std::sin(x) * std::cos(y) + z * z;
    const double kinks[] = {x - y, y - z, y - 0.1, s - 0.3, s - y, x - 0.3 * y, s, std::sin(s), y};
    if (std::ranges::all_of(kinks, [](double k) { return std::abs(k) > 0.05; }) && std::abs(std::cos(z)) < 0.99) out.push_back(m);
  }
  return out;
}

}  // namespace

TEST_CASE("rates and accelerations of every function are those that differences in time show, and those of jets") {
  Random random(21);
  each_function(random, [](const char* name, const Program& p, auto f, const Motion& m) {
    CAPTURE(name, m.numbers);
    CHECK(deviation(program::in_time(p, 2), m.numbers, differences_in_time(f, m)) < difference_tolerance);
    CHECK(deviation(program::in_time(p, 2), m.numbers, by_jets(f, m)) < rounding);
    const std::vector<double> rates(m.numbers.begin(), m.numbers.begin() + static_cast<std::ptrdiff_t>(2 * m.inputs()));
    CHECK(deviation(program::in_time(p, 1), rates, first_order(by_jets(f, m))) < rounding);
  });
}

TEST_CASE("partials of every function are those of the scalar that carries partials") {
  Random random(22);
  each_function(random, [](const char* name, const Program& p, auto f, const Motion& m) {
    std::vector<Partials<double, 2>> x;
    std::vector<int> by;
    for (std::size_t i = 0; i < m.inputs(); ++i) {
      x.push_back(Partials<double, 2>::variable(m.numbers[i], static_cast<int>(i)));
      by.push_back(static_cast<int>(i));
    }
    const auto y = f(x);
    std::vector<long double> expected{y[0].value};
    for (std::size_t i = 0; i < m.inputs(); ++i) expected.push_back(y[0].partial[i]);
    CAPTURE(name, m.numbers);
    CHECK(deviation(program::partials(p, by), {m.numbers.begin(), m.numbers.begin() + static_cast<std::ptrdiff_t>(by.size())}, expected) <
          rounding);
  });
}

TEST_CASE("derivatives of functions of functions, masks among them, are those of differences, jets and partials") {
  const Program p = everything();
  const int by[] = {2, 0};
  const Program twice = program::in_time(p, 2), partial = program::partials(p, by);
  for (const Motion& m : smooth_motions(100, 23)) {
    CAPTURE(m.numbers);
    CHECK(deviation(twice, m.numbers, differences_in_time(Everything(), m)) < difference_tolerance);
    CHECK(deviation(twice, m.numbers, by_jets(Everything(), m)) < rounding);
    std::vector<Partials<double, 3>> x;
    for (int i = 0; i < 3; ++i) x.push_back(Partials<double, 3>::variable(m.numbers[static_cast<std::size_t>(i)], i));
    const auto y = Everything()(x);
    std::vector<long double> expected;
    for (const auto& o : y) expected.push_back(o.value);
    for (const auto& o : y)
      for (const int i : by) expected.push_back(o.partial[static_cast<std::size_t>(i)]);
    CHECK(deviation(partial, {m.numbers.begin(), m.numbers.begin() + 3}, expected) < rounding);
  }
}

TEST_CASE("any sign that is wrong in a derivative is caught by differences") {
  const Program p = program::in_time(everything(), 2);
  const std::vector<Motion> motions = smooth_motions(30, 24);
  std::vector<std::vector<long double>> expected;
  for (const Motion& m : motions) expected.push_back(differences_in_time(Everything(), m));
  int planted = 0;
  for (std::size_t i = 0; i < p.steps().size(); ++i) {
    std::vector<Step> steps(p.steps().begin(), p.steps().end());
    switch (steps[i].operation) {
      case Operation::add:
        steps[i].operation = Operation::subtract;
        break;
      case Operation::subtract:
        steps[i].operation = Operation::add;
        break;
      case Operation::negate:
        steps[i].operation = Operation::abs;
        break;
      default:
        continue;
    }
    const Program wrong(steps, p.inputs(), p.outputs());
    double worst = 0;
    for (std::size_t k = 0; k < motions.size() && worst < difference_tolerance; ++k) {
      const double d = deviation(wrong, motions[k].numbers, expected[k]);
      if (!(d <= worst)) worst = d;
    }
    CAPTURE(i, program::name_of(p.steps()[i].operation));
    CHECK_FALSE(worst < difference_tolerance);
    ++planted;
  }
  CHECK(planted > 50);
}

TEST_CASE("a derivative at a kink is that of the side that is chosen") {
  const auto derivative = [](const Program& p, double x) {
    const int by[] = {0};
    std::vector<double> out(2);
    program::Evaluator<double>(program::partials(p, by)).run(std::vector<double>{x}, out);
    return out[1];
  };
  const Program size = recorded_of_one([](const auto& x) { return abs(x); });
  CHECK(derivative(size, -1) == -1);
  CHECK(derivative(size, 0) == 1);
  CHECK(derivative(size, 1) == 1);
  const Program low = recorded_of_one([](const auto& x) { return smaller(3.0 * x, x + 2.0); });
  CHECK(derivative(low, 0.5) == 3);
  CHECK(derivative(low, 1) == 1);  // equal: the second, as min(a, b) is a only where a < b
  CHECK(derivative(low, 1.5) == 1);
  const Program high = recorded_of_one([](const auto& x) { return larger(3.0 * x, x + 2.0); });
  CHECK(derivative(high, 0.5) == 1);
  CHECK(derivative(high, 1.5) == 3);
}

TEST_CASE("derivatives cost what one would write by hand") {
  // x^2 + y^2 + z^2, five operations: its rate is 2 (x x' + y y' + z z'), and the root's (x x' + y y' + z z') / length.
  const auto steps = [](const Program& p) {
    return std::ranges::count_if(p.steps(), [](const Step& s) { return program::operands_of(s.operation) > 0; });
  };
  const Program squares = recorded(3, [](const auto& x) { return std::vector<Recorded>{x[0] * x[0] + x[1] * x[1] + x[2] * x[2]}; });
  REQUIRE(steps(squares) == 5);
  CHECK(steps(program::in_time(squares, 1)) == 5 + 6);
  const Program length = recorded(3, [](const auto& x) { return std::vector<Recorded>{sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2])}; });
  CHECK(steps(program::in_time(length, 1)) == 6 + 5 + 2);
  // A rotation's derivative by its last angle is the rotation again, but for signs.
  const Program turned = recorded(3, [](const auto& x) {
    return std::vector<Recorded>{cos(x[0]) * x[1] - sin(x[0]) * x[2], sin(x[0]) * x[1] + cos(x[0]) * x[2]};
  });
  const int by[] = {0};
  CHECK(steps(program::partials(turned, by)) == steps(turned) + 1);
}

TEST_CASE("what does not depend on an input has the derivative zero, exactly") {
  const Program p = recorded(2, [](const auto& x) { return std::vector<Recorded>{sin(x[0]) / 3.0, Recorded(2.0), x[1]}; });
  const int by[] = {1};
  std::vector<double> out(6);
  program::Evaluator<double>(program::partials(p, by)).run(std::vector<double>{0.7, 0.2}, out);
  CHECK(out[3] == 0);
  CHECK(out[4] == 0);
  CHECK(out[5] == 1);
}
