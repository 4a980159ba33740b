#include <reports/figure/layout/label_groups.hpp>

#include <algorithm>
#include <cmath>

#include <reports/figure/layout/legend.hpp>

namespace pmreport::figure {
namespace {

constexpr double coincident = 0.5;  // [pt] curves that are nowhere farther apart are one line to the eye
constexpr double in_row = 2.5;      // [pt] between names in one row

bool coincide(const Series& a, const Series& b, const Frame& frame) {
  if (a.x != b.x || a.y.size() != b.y.size()) return false;
  for (std::size_t i = 0; i < a.y.size(); ++i) {
    if (std::isfinite(a.y[i]) != std::isfinite(b.y[i])) return false;
    if (std::isfinite(a.y[i]) && std::abs(to_page(frame, 0, a.y[i]).y - to_page(frame, 0, b.y[i]).y) > coincident) return false;
  }
  return true;
}

}  // namespace

std::vector<LabelGroup> label_groups(cairo_t* cr, const Panel& panel, const std::vector<Trace>& traces, const Frame& frame) {
  std::vector<LabelGroup> groups;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const Series& s = panel.series[i];
    if (s.label.empty() || (traces[i].strokes.empty() && traces[i].dots.empty())) continue;
    auto at = std::find_if(groups.begin(), groups.end(), [&](const LabelGroup& g) {
      return coincide(panel.series[static_cast<std::size_t>(g.series.front())], s, frame);
    });
    if (at == groups.end()) at = groups.emplace(groups.end());
    const Extents size = Text(cr, s.label, label_font).extents();
    at->width += size.width + (at->series.empty() ? 0 : in_row);
    at->height = size.height;
    at->series.push_back(static_cast<int>(i));
    at->widths.push_back(size.width);
  }
  return groups;
}

void add_labels(const Panel& panel, const LabelGroup& group, const LabelPlace& place, const Stroke& leader, bool inside,
                DirectLabels& out) {
  double left = place.left;
  for (std::size_t k = 0; k < group.series.size(); ++k) {
    const auto i = static_cast<std::size_t>(group.series[k]);
    out.labels.push_back({panel.series[i].label,
                          group.series[k],
                          style_of(panel.series[i], i),
                          {left, place.top, group.widths[k], place.height},
                          k == 0 ? leader : Stroke{},
                          inside});
    left += group.widths[k] + in_row;
  }
}

}  // namespace pmreport::figure
