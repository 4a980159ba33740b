// What the operation of a term makes of its operands, whatever kind of number they are: jets at a time, series over a span of time.
#pragma once

#include <core/scenario/expression/expression.hpp>
#include <limits>
#include <span>
#include <vector>

namespace pmreport::scenario {

// X brings the functions by name, among them power(x, n), step5(x, from, to), minimum, maximum and in_domain(x, low, high), which readies
// an operand for a function that has values between these two alone.
template <class X>
X applied(const Term& term, const X& a, const X& b, const X& c, const X& time) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  switch (term.operation) {
    case Operation::constant:
      return X(term.constant);
    case Operation::time:
      return time;
    case Operation::variable:
      return a;
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
      return sin(a);
    case Operation::cos:
      return cos(a);
    case Operation::tan:
      return tan(a);
    case Operation::asin:
      return asin(in_domain(a, -1, 1));
    case Operation::acos:
      return acos(in_domain(a, -1, 1));
    case Operation::atan:
      return atan(a);
    case Operation::atan2:
      return atan2(a, b);
    case Operation::sinh:
      return sinh(a);
    case Operation::cosh:
      return cosh(a);
    case Operation::tanh:
      return tanh(a);
    case Operation::sqrt:
      return sqrt(in_domain(a, 0, infinite));
    case Operation::exp:
      return exp(a);
    case Operation::log:
      return log(in_domain(a, 0, infinite));
    case Operation::abs:
      return abs(a);
    case Operation::min:
      return minimum(a, b);
    case Operation::max:
      return maximum(a, b);
    case Operation::step5:
      return step5(a, b, c);
  }
  return X(std::numeric_limits<double>::quiet_NaN());
}

// All terms in their order; `made` sees each before others use it. `variables`: what each stands for.
template <class X, class Made>
void evaluate_terms(std::span<const Term> terms, const X& time, std::span<const X> variables, std::vector<X>& out, Made&& made) {
  out.resize(terms.size());
  const X none(0.0);
  const auto of = [&](int i) -> const X& { return i < 0 ? none : out[static_cast<std::size_t>(i)]; };
  for (std::size_t i = 0; i < terms.size(); ++i) {
    const Term& term = terms[i];
    const bool variable = term.operation == Operation::variable;
    out[i] = applied(term, variable ? variables[static_cast<std::size_t>(term.a)] : of(term.a), of(term.b), of(term.c), time);
    made(i, out[i]);
  }
}
template <class X>
void evaluate_terms(std::span<const Term> terms, const X& time, std::span<const X> variables, std::vector<X>& out) {
  evaluate_terms(terms, time, variables, out, [](std::size_t, X&) {});
}

}  // namespace pmreport::scenario
