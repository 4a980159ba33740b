// The integral of an expression of time over a span of time: what it can be at any instant of it, proved by interval arithmetic.
#pragma once

#include <core/program/intervals/bounds.hpp>
#include <core/scenario/expression/expression.hpp>
#include <memory>
#include <mutex>
#include <pmreport/jet.hpp>
#include <vector>

namespace pmreport::scenario {

// F(t) = start + integral of f from the first time to t. Between two times f does little; where it does more, or is not smooth, they are
// halved. Computed when it is first asked for; safe in threads.
class IntegralEnclosure {
 public:
  // At least two times, rising. `magnitude`: of the integral of |f|, nearly; what is far less than it counts for nothing.
  IntegralEnclosure(Expression f, double start, std::vector<double> times, double magnitude)
      : f_(std::move(f)), start_(start), times_(std::move(times)), magnitude_(magnitude) {}

  // F, f and f' at every instant of the span, rounding included, as those of the expression itself (enclosure.hpp).
  Jet<program::Bounds> over(program::Bounds time) const;

 private:
  struct Panels;
  std::shared_ptr<const Panels> panels() const;

  Expression f_;
  double start_;
  std::vector<double> times_;
  double magnitude_;
  mutable std::once_flag once_{};
  mutable std::shared_ptr<const Panels> panels_{};
};

}  // namespace pmreport::scenario
