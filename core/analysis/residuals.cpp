#include <core/analysis/residuals.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

void set(Row& row, Measure m, double value, double error) {
  row.value[static_cast<std::size_t>(m)] = std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
  row.error[static_cast<std::size_t>(m)] = error;
}

Residuals::Residuals(std::size_t samples) {
  Row nothing;
  nothing.value.fill(std::numeric_limits<double>::quiet_NaN());
  nothing.error.fill(0);
  rows_.assign(samples, nothing);
}

Worst Residuals::worst(Measure m, double tolerance) const {
  constexpr double telling = 0.01;  // an error from which on two numbers that agree say nothing
  Worst w;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const double residual = rows_[k].value[static_cast<std::size_t>(m)], error = rows_[k].error[static_cast<std::size_t>(m)];
    if (std::isnan(residual)) continue;
    if (!(error < telling)) {
      ++w.undecided;
      continue;
    }
    ++w.compared;
    if (error > tolerance) ++w.poorly_known, w.poorest = std::max(w.poorest, error);
    const double value = error > tolerance ? residual * (tolerance / error) : residual;
    if (w.sample < 0 || value > w.value) w.value = value, w.sample = static_cast<int>(k);
  }
  return w;
}

}  // namespace pmreport::analysis
