#include <reports/figure/layout/offsets.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <reports/figure/layout/range.hpp>

namespace pmreport::figure {
namespace {

constexpr double longest = 1e9;    // no offset of more digits is a round number
constexpr double unmoved = 1e-11;  // of a curve's values: what moves by less does not move

struct Reach {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool empty() const { return low > high; }
  double span() const { return high - low; }
  double size() const { return empty() ? 0 : std::max(std::abs(low), std::abs(high)); }
  double middle() const { return low / 2 + high / 2; }
};

Reach reach_of(const Series& series) {
  Reach out;
  for (const double y : series.y)
    if (std::isfinite(y)) out.low = std::min(out.low, y), out.high = std::max(out.high, y);
  return out;
}

// The step of a round number that leaves little beside so much movement.
double step_for(double movement) { return std::pow(10.0, std::floor(std::log10(movement))); }

std::string less(double offset, double step, const std::string& unit) {
  const int decimals = std::max(0, static_cast<int>(std::lround(-std::log10(step))));
  std::string number = fmt::format("{:.{}f}", std::abs(offset), decimals);
  if (number.find('.') != std::string::npos) number.erase(number.find_last_not_of('0') + 1);
  if (number.ends_with('.')) number.pop_back();
  return (offset < 0 ? " + " : " − ") + number + (unit.empty() || unit == "°" ? unit : " " + unit);
}

}  // namespace

Panel set_off(const Panel& panel, double share) {
  if (panel.map || panel.equal || !panel.named.empty() || panel.series.size() < 2) return panel;
  const Interval shown = y_range(panel);
  for (const Line& line : panel.lines)
    if (line.y >= shown.low && line.y <= shown.high) return panel;
  std::vector<double> limits;
  for (const Line& line : panel.lines)
    if (std::isfinite(line.y)) limits.push_back(line.y);
  std::vector<Reach> reaches;
  double movement = 0, size = 0;
  for (const Series& s : panel.series) {
    reaches.push_back(reach_of(s));
    if (s.label.empty() || s.style >= 0 || reaches.back().size() > longest) return panel;
    if (reaches.back().empty()) continue;
    movement = std::max(movement, reaches.back().span());
    size = std::max(size, reaches.back().size());
  }
  if (movement > share * (shown.high - shown.low) || movement <= unmoved * size) return panel;
  const double step = step_for(movement);
  Panel out = panel;
  out.lines.clear();  // they are of the values themselves
  out.note = limits_off_scale(limits, panel.y.unit);
  for (std::size_t i = 0; i < out.series.size(); ++i) {
    const double offset = reaches[i].empty() ? 0 : std::round(reaches[i].middle() / step) * step;
    if (offset == 0) continue;
    for (double& y : out.series[i].y) y -= offset;
    out.series[i].label += less(offset, step, panel.y.unit);
  }
  out.y.label += " − offset";
  return out;
}

Figure set_off(const Figure& figure) {
  Figure out = figure;
  for (Panel& panel : out.panels) panel = set_off(panel);
  return out;
}

}  // namespace pmreport::figure
