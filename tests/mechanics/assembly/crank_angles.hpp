// The assembly modes of the slider-crank, by hand.
#pragma once

#include <tests/given/slider_crank.hpp>

#include <cmath>
#include <vector>

namespace pmreport::test {

// The angles at which the pin of the slider-crank is a rod's length from the slider at s: r^2 + |C|^2 - 2 r (Cx cos + Cy sin) = L^2.
inline std::vector<double> crank_angles(double s) {
  const double r = 0.2, length = 0.5;
  const Eigen::Vector3d c = SliderCrank::c0() + s * SliderCrank::e();
  const double middle = std::atan2(c.y(), c.x());
  const double half = std::acos((r * r + c.squaredNorm() - length * length) / (2 * r * std::hypot(c.x(), c.y())));
  return {middle - half, middle + half};
}

}  // namespace pmreport::test
