#include <core/analysis/residuals.hpp>

#include <cmath>
#include <limits>

namespace pmreport::analysis {

void set(Row& row, Measure m, double value) {
  row[static_cast<std::size_t>(m)] = std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
}

Residuals::Residuals(std::size_t samples) {
  Row nothing;
  nothing.fill(std::numeric_limits<double>::quiet_NaN());
  rows_.assign(samples, nothing);
}

Worst Residuals::worst(Measure m) const {
  Worst w;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const double x = rows_[k][static_cast<std::size_t>(m)];
    if (std::isnan(x)) continue;
    ++w.compared;
    if (w.sample < 0 || x > w.value) w.value = x, w.sample = static_cast<int>(k);
  }
  return w;
}

}  // namespace pmreport::analysis
