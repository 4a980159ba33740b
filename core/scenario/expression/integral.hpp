// The integral of a function of time, exact to rounding for everything smooth.
#pragma once

#include <functional>
#include <vector>

namespace pmreport::scenario {

// F(t) = start + integral of f from the first knot to t. Between knots by Gauss-Legendre of ten points (exact for polynomials to degree
// 19), halved until two halves agree with the whole, so that a kink such as that of abs or max costs accuracy only where it stands.
class Integral {
 public:
  // At least one knot, rising.
  Integral(std::function<double(double)> f, double start, std::vector<double> knots);
  double at(double t) const;  // not finite where f is not

 private:
  std::function<double(double)> f_;
  std::vector<double> knots_, values_;
};

}  // namespace pmreport::scenario
