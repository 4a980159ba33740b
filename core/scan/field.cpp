#include <core/program/batch.hpp>
#include <core/scan/field.hpp>
#include <core/scan/grid_size.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::scan {

Field sample_field(const PoseSet& set, const Scan& scan) {
  Scan points = scan;
  points.orientations.clear();
  const std::size_t n = poses_of(points), inputs = scan.at.size(), margins = set.margins.outputs().size();
  std::vector<double> poses(inputs * n), values(set.size() * n);
  for (std::size_t i = 0; i < inputs; ++i) std::fill_n(poses.begin() + static_cast<std::ptrdiff_t>(i * n), n, scan.at[i]);
  for (std::size_t a = 0, inside = n; a < scan.points.size(); ++a) {
    const Axis& axis = scan.points[a];
    inside /= axis.count;
    for (std::size_t k = 0; k < n; ++k) poses[static_cast<std::size_t>(axis.input) * n + k] = axis.value(k / inside % axis.count);
  }
  program::Batch(set.margins).run(n, poses.data(), values.data());
  if (set.late.size > 0) set.late.judge(n, poses.data(), values.data() + margins * n);

  Field out{scan.points, {}};
  for (std::size_t m = 0; m < set.size(); ++m)
    out.margins.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(m * n),
                             values.begin() + static_cast<std::ptrdiff_t>((m + 1) * n));
  for (std::size_t k = 0; k < n; ++k)
    if (!(out.margins.front()[k] >= -set.rounding.front()))
      for (std::size_t m = 1; m < set.size(); ++m) out.margins[m][k] = std::numeric_limits<double>::quiet_NaN();
  return out;
}

// The scale of a margin: its largest value in the field, so that none hides the others for its unit. Where the reach is negative the others
// are no numbers, and it alone tells how far away the set is.
std::vector<double> Field::least() const {
  if (margins.empty()) return {};
  std::vector<double> out(margins.front().size(), std::numeric_limits<double>::infinity());
  for (const std::vector<double>& margin : margins) {
    double scale = 0;
    for (const double x : margin)
      if (std::isfinite(x)) scale = std::max(scale, std::abs(x));
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double x = scale > 0 ? margin[k] / scale : margin[k];
      const bool told_by_the_reach = std::isnan(x) && margins.front()[k] < 0;
      if (!told_by_the_reach && !(out[k] <= x)) out[k] = std::isnan(out[k]) ? out[k] : x;
    }
  }
  return out;
}

}  // namespace pmreport::scan
