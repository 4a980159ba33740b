#include <core/analysis/samples/smooth_rate.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::analysis {

std::optional<SmoothRate> smooth_rate(const std::function<double(double)>& f, double t, double begin, double end) {
  constexpr double widest = 1.0 / 16;  // step, of the whole interval
  // Of neighbouring steps no two are multiples of one period, as halves are: what swings faster than the step would look constant to both.
  constexpr double shrink = 1 / std::numbers::phi;
  constexpr int steps = 13;
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};  // of f(t + n h) - f(t - n h), over h
  double step = std::min({widest * (end - begin), (t - begin) / 4, (end - t) / 4});
  if (!(step > 0)) return std::nullopt;
  const auto rate = [&] {
    double sum = 0;
    for (int n = 1; n <= 4; ++n) sum += weights[n - 1] * (f(t + n * step) - f(t - n * step));
    return sum / step;
  };
  std::optional<SmoothRate> best;
  double before = rate();
  for (int n = 0; n < steps; ++n) {
    step *= shrink;
    const double now = rate(), change = std::abs(now - before);
    if (std::isfinite(change) && (!best || change < best->change)) best = {now, change};
    before = now;
  }
  return best;
}

}  // namespace pmreport::analysis
