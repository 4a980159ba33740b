#include <reports/figure/layout/direct_labels.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <reports/figure/layout/label_groups.hpp>
#include <reports/figure/parts.hpp>

namespace pmreport::figure {
namespace {

constexpr double widest_share = 0.2;  // of the frame: longer names stand inside
constexpr double row_pitch = 7.8;     // [pt] between names in the column
constexpr double nearest_ends = 1.0;  // [pt] ends that are closer cannot be told apart
constexpr double farthest = 17;       // [pt] a name may move so far from the end of its curve
constexpr double leader_length = 7;   // [pt] across the gap between frame and names
constexpr double at_end = 2.5;        // [pt] from the frame to a name without a leader
constexpr double leader_width = 0.4;

// Heights at least `row_pitch` apart, in their order, the sum of squared moves least: neighbours that would overlap pool, and a pool stands
// where its members pull it on average.
std::vector<double> moved_apart(const std::vector<double>& wanted, double low, double high) {
  struct Pool {
    double sum;  // of the heights wanted, each less its place in the pool
    int size;
    double top() const { return sum / size; }
  };
  std::vector<Pool> pools;
  for (const double y : wanted) {
    pools.push_back({y, 1});
    while (pools.size() > 1) {
      const Pool last = pools.back(), before = pools[pools.size() - 2];
      if (before.top() + before.size * row_pitch <= last.top()) break;
      pools.pop_back();
      pools.back() = {before.sum + last.sum - last.size * (before.size * row_pitch), before.size + last.size};
    }
  }
  std::vector<double> out;
  for (const Pool& p : pools)
    for (int k = 0; k < p.size; ++k) out.push_back(p.top() + k * row_pitch);
  // Pools at the ends are pushed back into the frame.
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::max(out[i], i == 0 ? low : out[i - 1] + row_pitch);
  for (std::size_t i = out.size(); i-- > 0;) out[i] = std::min(out[i], i + 1 == out.size() ? high : out[i + 1] - row_pitch);
  return out;
}

}  // namespace

bool may_label_directly(const Panel& panel) {
  if (panel.map || panel.equal || !panel.named.empty() || !panel.y.names.empty()) return false;
  std::size_t named = 0;
  for (const Series& s : panel.series) {
    if (s.points) return false;
    named += s.label.empty() ? 0 : 1;
  }
  return named >= 1 && named <= most_direct_labels;
}

std::optional<DirectLabels> label_ends(cairo_t* cr, const Panel& panel, const std::vector<Trace>& traces, const Frame& frame) {
  const std::vector<LabelGroup> groups = label_groups(cr, panel, traces, frame);
  struct End {
    std::size_t group;
    double y;
  };
  std::vector<End> ends;
  double widest = 0, height = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Trace& trace = traces[static_cast<std::size_t>(groups[g].series.front())];
    if (trace.strokes.empty()) return std::nullopt;
    const Point last = trace.strokes.back().back();
    if (last.x < frame.width - 0.5) return std::nullopt;
    ends.push_back({g, last.y});
    widest = std::max(widest, groups[g].width);
    height = std::max(height, groups[g].height);
  }
  if (ends.empty() || widest > widest_share * frame.width) return std::nullopt;
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.y < b.y; });
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (ends[i].y - ends[i - 1].y < nearest_ends) return std::nullopt;
  std::vector<double> wanted;
  for (const End& e : ends) wanted.push_back(e.y);
  const double half = height / 2;
  const std::vector<double> found = moved_apart(wanted, half - 3, frame.height - half + 3);
  bool moved = false;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (std::abs(found[i] - wanted[i]) > farthest) return std::nullopt;
    moved = moved || std::abs(found[i] - wanted[i]) > 0.8;
  }
  DirectLabels out;
  const double left = frame.width + (moved ? leader_length + leader_gap : at_end);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Stroke leader = moved ? Stroke{{frame.width + 1, wanted[i]}, {frame.width + leader_length, found[i]}} : Stroke{};
    add_labels(panel, groups[ends[i].group], {left, found[i] - half, height}, leader, false, out);
  }
  out.right = left - frame.width + widest;
  return out;
}

void draw_direct_labels(cairo_t* cr, const DirectLabels& labels) {
  for (const DirectLabel& label : labels.labels) {
    begin_part(cr, fmt::format("class=\"key\" data-series=\"{}\"", label.series));
    const Colour colour = line_style(label.style).colour;
    if (!label.leader.empty()) {
      set_colour(cr, colour);
      cairo_set_line_width(cr, leader_width);
      cairo_move_to(cr, label.leader.front().x, label.leader.front().y);
      cairo_line_to(cr, label.leader.back().x, label.leader.back().y);
      cairo_stroke(cr);
    }
    const Text text(cr, label.text, label_font);
    const double top = label.box.y + (label.box.height - text.extents().height) / 2;
    if (label.inside) clear_ground(cr, label.box);
    set_colour(cr, as_text(colour));
    text.show(label.box.x, top);
    end_part(cr);
  }
}

}  // namespace pmreport::figure
