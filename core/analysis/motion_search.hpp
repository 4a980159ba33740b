// Looking for a time between samples at which something happens.
#pragma once

#include <core/mechanics/trajectory/trajectory.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace pmreport::analysis {

// The coordinates at a time [s]; NaN where there is no pose.
class PosesInTime {
 public:
  PosesInTime(const mechanics::Trajectory& motion, int dof) : motion_(motion), unused_(dof) {}
  Eigen::VectorXd at(double t) {
    Eigen::VectorXd q(unused_.size());
    if (!motion_.at || !motion_.at(t, q.data(), unused_.data(), unused_.data())) q.setConstant(std::numeric_limits<double>::quiet_NaN());
    return q;
  }

 private:
  const mechanics::Trajectory& motion_;
  Eigen::VectorXd unused_;
};

// The time in [low, high] up to which `holds` is true, which it is at `low` and not at `high`: halved until the two are neighbours.
template <class Holds>
double last_time(double low, double high, Holds&& holds) {
  while (true) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return low;
    (holds(middle) ? low : high) = middle;
  }
}

// By golden section the time of the least value(t) in [low, high], to half the digits of a double, as far as a minimum shows; stops at the
// first value that is not above zero.
template <class Value>
double least_time(double low, double high, Value&& value) {
  constexpr double share = 1 / std::numbers::phi;
  double a = high - share * (high - low), b = low + share * (high - low), at_a = value(a), at_b = value(b);
  while (high - low > 1e-13 * std::abs(high) && at_a > 0 && at_b > 0) {
    if (at_a < at_b) {
      high = b, b = a, at_b = at_a;
      a = high - share * (high - low);
      if (!(a > low)) break;
      at_a = value(a);
    } else {
      low = a, a = b, at_a = at_b;
      b = low + share * (high - low);
      if (!(b < high)) break;
      at_b = value(b);
    }
  }
  return at_a < at_b ? a : b;
}

}  // namespace pmreport::analysis
