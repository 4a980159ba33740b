#include <core/analysis/samples/stretch.hpp>

#include <algorithm>
#include <iterator>

namespace pmreport::analysis {

std::vector<double> knots_along(const mechanics::Trajectory& trajectory, const scenario::Load& load) {
  std::vector<double> out;
  std::set_union(trajectory.knots.begin(), trajectory.knots.end(), load.knots.begin(), load.knots.end(), std::back_inserter(out));
  return out;
}

Stretch stretch_at(const std::vector<double>& knots, double t, double begin, double end) {
  const auto after = std::upper_bound(knots.begin(), knots.end(), t);
  return {after != knots.begin() ? std::max(*(after - 1), begin) : begin, after != knots.end() ? std::min(*after, end) : end};
}

}  // namespace pmreport::analysis
