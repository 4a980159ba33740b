#include <reports/figure/layout/range.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pmreport::figure {
namespace {

constexpr double margin = 0.05;         // of the range, above and below
constexpr double near = 1.5;            // ranges: a limit line farther from the data is left out
constexpr double spike = 20;            // core widths: values farther from the core are spikes
constexpr double kept = 1.0;            // core widths shown beyond the core on the side of a spike
constexpr double tail = 0.05;           // share of a curve's values outside its core, on each side
constexpr double row_margin = 0.6;      // beyond the first and the last row of names
constexpr std::size_t few_values = 20;  // too few to tell a spike from the rest

struct Hull {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool empty() const { return low > high; }
  double width() const { return high - low; }
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

std::vector<double> finite_y(const Series& series) {
  std::vector<double> values;
  for (std::size_t i = 0; i < std::min(series.x.size(), series.y.size()); ++i) {
    if (std::isfinite(series.x[i]) && std::isfinite(series.y[i])) values.push_back(std::clamp(series.y[i], -largest, largest));
  }
  return values;
}

double quantile(std::vector<double>& values, double share) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

// Near a singularity a force grows without bound for a few samples and would flatten everything else. Each curve's core is what lies
// between its 5 % and 95 % quantiles; the union of the cores says what the panel is about. Quantiles of the pooled values would take one
// large curve among small ones for a spike. A core without width (a rest with one pulse) judges nothing.
Hull without_spikes(const Hull& full, const Hull& core) {
  const double width = core.width();
  if (width <= 1e-9 * std::max(std::abs(core.low), std::abs(core.high))) return full;
  Hull shown = full;
  if (full.high > core.high + spike * width) shown.high = core.high + kept * width;
  if (full.low < core.low - spike * width) shown.low = core.low - kept * width;
  return shown;
}

bool has_points(const Panel& panel) {
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& series) { return series.points; });
}

Hull hull_of_data(const Panel& panel) {
  Hull full, core;
  for (const Series& series : panel.series) {
    std::vector<double> values = finite_y(series);
    if (values.empty()) continue;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    full.include(*low);
    full.include(*high);
    const bool few = values.size() < few_values;
    core.include(few ? *low : quantile(values, tail));
    core.include(few ? *high : quantile(values, 1 - tail));
  }
  for (const NamedLine& line : panel.named)
    for (std::size_t i = 0; i < std::min(line.x.size(), line.y.size()); ++i)
      if (std::isfinite(line.x[i]) && std::isfinite(line.y[i])) full.include(std::clamp(line.y[i], -largest, largest));
  // A point that lies apart is no spike of a curve.
  return full.empty() || panel.equal || has_points(panel) || core.empty() ? full : without_spikes(full, core);
}

}  // namespace

bool has_data(const Panel& panel) {
  if (panel.map) return std::any_of(panel.map->values.begin(), panel.map->values.end(), [](double v) { return std::isfinite(v); });
  return std::any_of(panel.series.begin(), panel.series.end(), [](const Series& series) { return !finite_y(series).empty(); }) ||
         std::any_of(panel.named.begin(), panel.named.end(), [](const NamedLine& line) {
           return !finite_y({"", line.x, line.y, 0}).empty();
         });
}

Interval x_range(const Panel& panel) {
  if (panel.map) return widened({panel.map->x.front(), panel.map->x.back()});
  Hull hull;
  for (const Series& series : panel.series) {
    for (const double x : series.x) {
      if (std::isfinite(x)) hull.include(x);
    }
  }
  for (const NamedLine& line : panel.named)
    for (const double x : line.x)
      if (std::isfinite(x)) hull.include(x);
  if (hull.empty()) return {0, 1};
  const Interval base = widened({hull.low, hull.high});
  const double pad = panel.equal || has_points(panel) ? margin * (base.high - base.low) : 0;
  return {base.low - pad, base.high + pad};
}

Interval y_range(const Panel& panel, double headroom) {
  if (panel.map) return widened({panel.map->y.front(), panel.map->y.back()});
  if (!panel.y.names.empty()) return {-row_margin, static_cast<double>(panel.y.names.size()) - 1 + row_margin};
  const Hull data = hull_of_data(panel);
  if (data.empty()) return {0, 1};
  const Interval base = widened({data.low, data.high});
  Hull shown{base.low, base.high};
  for (const Line& line : panel.lines) {
    const double reach = near * (base.high - base.low);
    if (line.y >= base.low - reach && line.y <= base.high + reach) shown.include(line.y);
  }
  const double pad = margin * shown.width();
  return {shown.low - pad, shown.high + pad + headroom * shown.width()};
}

EqualFrame fit_equal(Interval x, Interval y, double width, double height) {
  const double scale = std::min(width / (x.high - x.low), height / (y.high - y.low));  // [pt] of a step of one
  const auto fit = [&](Interval range, double least, double most) {
    const double side = (range.high - range.low) * scale, spare = (std::min(least, most) - side) / scale / 2;
    if (spare <= 0) return std::pair{std::min(side, most), range};
    return std::pair{std::min(least, most), Interval{range.low - spare, range.high + spare}};
  };
  const auto [across, wide] = fit(x, least_equal_width, width);
  const auto [down, high] = fit(y, least_equal_height, height);
  return {across, down, wide, high};
}

std::string limits_off_scale(std::vector<double> limits, const std::string& unit) {
  if (limits.empty()) return "";
  std::sort(limits.begin(), limits.end());
  const std::string beside = unit.empty() || unit == "°" ? unit : " " + unit;
  const double low = limits.front(), high = limits.back();
  if (low == high) return "limit " + typeset(low, 4) + beside + " off the scale";
  return "limits " + (low == -high ? "±" + typeset(high, 4) : typeset(low, 4) + " to " + typeset(high, 4)) + beside + " off the scale";
}

}  // namespace pmreport::figure
