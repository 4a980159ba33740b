// What must be true of an interval type, whichever: so that types with an error planted can be shown to fail. Files named *_upward.cpp
// only.
#pragma once

#include <core/program/intervals/interval.hpp>
#include <core/program/intervals/rounding.hpp>
#include <tests/judges/interval_judges.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pmreport::judges {

using program::round_upward;

// Ours, under the names of judged_operations().
template <class I>
I ours(std::string_view name, const I& x, const I& y) {
  if (name == "x + y") return x + y;
  if (name == "x - y") return x - y;
  if (name == "x y") return x * y;
  if (name == "x / y") return x / y;
  if (name == "-x") return -x;
  if (name == "abs") return abs(x);
  if (name == "square") return square(x);
  if (name == "sqrt") return sqrt(x);
  if (name == "sin") return sin(x);
  if (name == "cos") return cos(x);
  if (name == "tan") return tan(x);
  if (name == "asin") return asin(x);
  if (name == "acos") return acos(x);
  if (name == "atan2") return atan2(x, y);
  if (name == "hypot") return hypot(x, y);
  if (name == "smaller") return smaller(x, y);
  if (name == "larger") return larger(x, y);
  if constexpr (requires { pow(x, 2.0); }) {  // what scalars of the geometry need not have
    if (name == "atan") return atan(x);
    if (name == "exp") return exp(x);
    if (name == "log") return log(x);
    if (name == "sinh") return sinh(x);
    if (name == "cosh") return cosh(x);
    if (name == "tanh") return tanh(x);
    for (const auto& [power, n] : {std::pair("x^2", 2.0),
                                   {"x^3", 3.0},
                                   {"x^7", 7.0},
                                   {"x^-1", -1.0},
                                   {"x^-2", -2.0},
                                   {"x^0.5", 0.5},
                                   {"x^1.7", 1.7},
                                   {"x^-0.3", -0.3}})
      if (name == power) return pow(x, n);
  }
  throw std::logic_error("no such operation: " + std::string(name));
}

struct Verdict {
  std::optional<std::string> wrong;  // the first of all
  int bounded = 0;                   // of the answers
};

// `count` random operands, of each the range and a point.
template <class I>
Verdict verdict(const JudgedOperation& o, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  struct Asked {
    Bounds a, b, answer;
  };
  std::vector<Asked> all(static_cast<std::size_t>(count));
  for (Asked& x : all) x = {operand(o.from, random), operand(o.from, random), {}};
  round_upward([&] {
    for (Asked& x : all) x.answer = program::Interval(ours(o.name, I(program::Interval(x.a)), I(program::Interval(x.b)))).bounds();
  });
  Verdict out;
  Judges judges;
  for (const Asked& x : all) {
    out.wrong = judges.wrong(o, x.a, x.b, x.answer, random);
    if (out.wrong) return out;
    out.bounded += x.answer.bounded() ? 1 : 0;
  }
  return out;
}

// Derivatives through a scalar T of value and derivatives, at a point within: `of` makes one from an interval, `derivative` takes the first
// or second from it.
template <class T, class Of, class Derivative>
std::optional<std::string> wrong_derivative(const JudgedOperation& o, int order, std::pair<double, double> within, std::uint64_t seed,
                                            Of&& of, Derivative&& derivative) {
  std::mt19937_64 random(seed);
  Judges judges;
  const auto share = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int i = 0; i < 2000; ++i) {
    const double low = within.first + share() * (within.second - within.first), width = std::exp2(-4 - 40 * share());
    const Bounds box{low, low + width}, bounds = round_upward([&] {
                                          const T x = of(program::Interval(box));
                                          return program::Interval(derivative(ours<T>(o.name, x, x))).bounds();
                                        });
    if (!bounds.bounded()) return "no bounds on the derivative of " + std::string(o.name);
    if (auto wrong = judges.wrong_derivative(o, order, std::clamp(low + share() * width, box.low, box.high), bounds)) return wrong;
  }
  return {};
}

}  // namespace pmreport::judges
