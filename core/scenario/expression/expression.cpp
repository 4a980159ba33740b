#include <cmath>
#include <core/scenario/expression/expression.hpp>

namespace pmreport::scenario {
namespace {

using J = Jet<double>;

// x^n. The factors n and n(n-1) that are zero come first: 0 * infinity at x = 0 is no derivative of x^0 or x^1.
J power(const J& x, double n) {
  const double df = n == 0 ? 0 : n * std::pow(x.value, n - 1);
  const double ddf = n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(x.value, n - 2);
  return chain(x, std::pow(x.value, n), df, ddf);
}

// 10 u^3 - 15 u^4 + 6 u^5, the lowest polynomial from 0 to 1 with zero rate and acceleration at both ends; 0 before, 1 after.
J step5(const J& x, const J& from, const J& to) {
  const J u = (x - from) / (to - from);
  if (!(u.value > 0)) return u.value <= 0 ? J(0.0) : u;
  if (u.value >= 1) return J(1.0);
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

J apply(const Term& term, const J& a, const J& b, const J& c, double t) {
  const double x = a.value;
  switch (term.operation) {
    case Operation::constant:
      return {term.constant};
    case Operation::time:
      return {t, 1, 0};
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
      return asin(a);
    case Operation::acos:
      return acos(a);
    case Operation::atan:
      return atan2(a, J(1.0));
    case Operation::atan2:
      return atan2(a, b);
    case Operation::sinh:
      return chain(a, std::sinh(x), std::cosh(x), std::sinh(x));
    case Operation::cosh:
      return chain(a, std::cosh(x), std::sinh(x), std::cosh(x));
    case Operation::tanh: {
      const double y = std::tanh(x), slope = 1 - y * y;
      return chain(a, y, slope, -2 * y * slope);
    }
    case Operation::sqrt:
      return sqrt(a);
    case Operation::exp:
      return chain(a, std::exp(x), std::exp(x), std::exp(x));
    case Operation::log:
      return chain(a, std::log(x), 1 / x, -1 / (x * x));
    case Operation::abs:
      return abs(a);
    // What is not a number loses every comparison and would vanish here.
    case Operation::min:
      return b < a || std::isnan(b.value) ? b : a;
    case Operation::max:
      return a < b || std::isnan(b.value) ? b : a;
    case Operation::step5:
      return step5(a, b, c);
  }
  return {};
}

}  // namespace

void Expression::evaluate(double t, std::span<const Jet<double>> variables, std::vector<Jet<double>>& terms) const {
  terms.resize(terms_.size());
  const auto value = [&](int i) { return i < 0 ? J() : terms[static_cast<std::size_t>(i)]; };
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    const Term& term = terms_[i];
    terms[i] = term.operation == Operation::variable ? variables[static_cast<std::size_t>(term.a)]
                                                     : apply(term, value(term.a), value(term.b), value(term.c), t);
  }
}

Jet<double> Expression::at(double t, std::span<const Jet<double>> variables) const {
  std::vector<J> terms;
  evaluate(t, variables, terms);
  return terms.back();
}

}  // namespace pmreport::scenario
