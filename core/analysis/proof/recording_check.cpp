#include <core/analysis/proof/recording_check.hpp>

#include <core/program/evaluate.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

namespace {

double magnitude(std::span<const double> x) {
  double out = 0;
  for (const double v : x) out = std::max(out, std::abs(v));
  return out;
}

// Relative to the largest of these numbers; infinite where either has no value.
double difference(std::span<const double> x, std::span<const double> y) {
  double out = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double d = std::abs(x[i] - y[i]);
    out = std::max(out, std::isnan(d) ? std::numeric_limits<double>::infinity() : d);
  }
  const double size = magnitude(y);
  return size > 0 ? out / size : out;
}

}  // namespace

double recording_deviation(const mechanics::Machine& machine, const mechanics::Trajectory& trajectory, int samples) {
  const std::size_t placed = machine.layout().size();
  program::Evaluator<double> program(*machine.program());
  std::vector<double> recorded(placed + 36), placement(placed), wrenches(36);
  double worst = std::numeric_limits<double>::quiet_NaN();
  const int all = trajectory.samples(), count = std::min(samples, all);
  for (int k = 0; k < count; ++k) {
    const int sample = count > 1 ? static_cast<int>(static_cast<long>(k) * (all - 1) / (count - 1)) : 0;
    if (!trajectory.reaches(sample)) continue;
    const Eigen::VectorXd q = trajectory.value.row(sample);
    if (machine.place(PM_VALUE, 1, q.data(), placement.data()) != PM_OK) continue;
    program.run({q.data(), static_cast<std::size_t>(q.size())}, recorded);
    double here = difference(std::span(recorded).first(placed), placement);
    if (machine.jacobian(PM_VALUE, 1, placement.data(), wrenches.data()) == PM_OK && std::isfinite(magnitude(wrenches)))
      for (std::size_t row = 0; row < 6; ++row)
        here = std::max(here, difference(std::span(recorded).subspan(placed + 6 * row, 6), std::span(wrenches).subspan(6 * row, 6)));
    if (!(here <= worst)) worst = here;
  }
  return worst;
}

}  // namespace pmreport::analysis
