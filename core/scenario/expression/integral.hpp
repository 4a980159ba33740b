// The integral of a function of time, exact to rounding for everything smooth; it knows how good it is.
#pragma once

#include <functional>
#include <pmreport/jet.hpp>
#include <vector>

namespace pmreport::scenario {

// F(t) = start + integral of f from the first knot to t. Between knots by Gauss-Legendre of ten points (exact for polynomials to degree
// 19), halved until two halves agree with the whole, so that a kink that is no knot costs accuracy only where it stands.
class Integral {
 public:
  // At least one knot, rising. `f` with its rate, by which it is known how far the rounding of t may change it; a rate of zero: not at all.
  Integral(std::function<Jet<double>(double)> f, double start, std::vector<double> knots);
  double at(double t) const;  // not finite where f is not
  // What the halves that never agreed leave open of F at the end, as far as their disagreement tells; and the integral of |f|.
  double error() const { return error_; }
  double magnitude() const { return magnitude_; }

 private:
  struct Sum {
    double value = 0, magnitude = 0, slope = 0;  // of f, |f| and |f'|
  };
  Sum gauss(double a, double b) const;
  void add(double a, double b, const Sum& whole, double allowed, int depth);

  std::function<Jet<double>(double)> f_;
  std::vector<double> ends_{}, values_{};  // of the panels: one more than there are of these
  std::size_t given_ = 0;                  // knots
  double carried_ = 0;                     // what the last value lost by rounding
  double error_ = 0, magnitude_ = 0;
};

}  // namespace pmreport::scenario
