#include <cmath>
#include <core/scenario/expression/terms.hpp>

namespace pmreport {

// What a jet (pmreport/jet.hpp) does not bring of itself.
using J = Jet<double>;

// x^n. The factors n and n(n-1) that are zero come first: 0 * infinity at x = 0 is no derivative of x^0 or x^1.
static J power(const J& x, double n) {
  const double df = n == 0 ? 0 : n * std::pow(x.value, n - 1);
  const double ddf = n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(x.value, n - 2);
  return chain(x, std::pow(x.value, n), df, ddf);
}

// 10 u^3 - 15 u^4 + 6 u^5, the lowest polynomial from 0 to 1 with zero rate and acceleration at both ends; 0 before, 1 after.
static J step5(const J& x, const J& from, const J& to) {
  const J u = (x - from) / (to - from);
  if (!(u.value > 0)) return u.value <= 0 ? J(0.0) : u;
  if (u.value >= 1) return J(1.0);
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

static J atan(const J& x) { return atan2(x, J(1.0)); }
static J sinh(const J& x) { return chain(x, std::sinh(x.value), std::cosh(x.value), std::sinh(x.value)); }
static J cosh(const J& x) { return chain(x, std::cosh(x.value), std::sinh(x.value), std::cosh(x.value)); }
static J tanh(const J& x) {
  const double y = std::tanh(x.value), slope = 1 - y * y;
  return chain(x, y, slope, -2 * y * slope);
}
static J exp(const J& x) { return chain(x, std::exp(x.value), std::exp(x.value), std::exp(x.value)); }
static J log(const J& x) { return chain(x, std::log(x.value), 1 / x.value, -1 / (x.value * x.value)); }

// What is not a number loses every comparison and would vanish here.
static J minimum(const J& a, const J& b) { return b < a || std::isnan(b.value) ? b : a; }
static J maximum(const J& a, const J& b) { return a < b || std::isnan(b.value) ? b : a; }

static J in_domain(const J& x, double, double) { return x; }  // beyond it there is no number

}  // namespace pmreport

namespace pmreport::scenario {

void Expression::evaluate(double t, std::span<const Jet<double>> variables, std::vector<Jet<double>>& terms) const {
  evaluate_terms(std::span<const Term>(terms_), J(t, 1, 0), variables, terms);
}

Jet<double> Expression::at(double t, std::span<const Jet<double>> variables) const {
  std::vector<J> terms;
  evaluate(t, variables, terms);
  return terms.back();
}

}  // namespace pmreport::scenario
