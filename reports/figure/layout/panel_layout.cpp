#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <reports/figure/colour_scale.hpp>
#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/marks.hpp>
#include <reports/figure/layout/range.hpp>
#include <reports/figure/palette.hpp>
#include <reports/figure/shading.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double y_tick_pitch = 18;  // [pt] about, between major ticks
constexpr double x_tick_pitch = 30;
constexpr double label_distance = 7;  // [pt] at least, between tick labels side by side
constexpr double line_label_gap = 0.8;

// How far the range may be opened to make room for the legend, tried in this order.
constexpr double headrooms[] = {0, 0.16, 0.42};

Extents measure(cairo_t* cr, const std::string& text) { return Text(cr, text, {.size = tick_size}).extents(); }

// As many ticks as their labels leave room for.
Scale horizontal_scale(cairo_t* cr, Interval range, double width) {
  for (int wanted = static_cast<int>(width / x_tick_pitch) + 1;; --wanted) {
    Scale scale = make_scale(range.low, range.high, wanted);
    double widest = 0;
    for (const Tick& tick : scale.major) widest = std::max(widest, measure(cr, tick.label).width);
    if (wanted <= 2 || scale.major.size() < 2) return scale;
    const double pitch = width * (scale.position(scale.major[1].value) - scale.position(scale.major[0].value));
    if (widest + label_distance <= pitch) return scale;
  }
}

// An axis with fewer than two numbers has no scale.
Scale vertical_scale(Interval range, double height) {
  const int wanted = std::max(3, static_cast<int>(height / y_tick_pitch) + 1);
  for (int more = 0;; ++more) {
    Scale scale = make_scale(range.low, range.high, wanted + more);
    if (scale.major.size() >= 2 || more == wanted) return scale;
  }
}

// Names in the place of numbers.
Scale rows_of(const std::vector<std::string>& names, Interval range) {
  Scale scale;
  scale.low = range.low, scale.high = range.high;
  for (std::size_t k = 0; k < names.size(); ++k) scale.major.push_back({static_cast<double>(k), names[k]});
  return scale;
}

// Everything but the legend, for one range of y.
void fill(const Panel& panel, Interval y, double width, double height, PanelLayout& layout) {
  layout.window = {width, height, {layout.x.low, layout.x.high}, y};
  layout.y = panel.y.names.empty() ? vertical_scale(y, height) : rows_of(panel.y.names, y);
  layout.traces.clear();
  for (const Series& series : panel.series)
    layout.traces.push_back(series.points ? trace_of_points(series.x, series.y, layout.window) : trace(series.x, series.y, layout.window));
  layout.limit_bands = band_boxes(panel.bands, Band::Kind::limit, layout.window);
  layout.unreachable_bands = band_boxes(panel.bands, Band::Kind::unreachable, layout.window);
  layout.lines.clear();
  for (const Line& line : panel.lines) {
    if (!(line.y >= y.low && line.y <= y.high)) continue;
    const double at = to_page(layout.window, 0, line.y).y;
    layout.lines.push_back(at);
    if (line.forbids == Line::Forbids::above) layout.limit_bands.push_back({0, 0, width, at});
    if (line.forbids == Line::Forbids::below) layout.limit_bands.push_back({0, at, width, height - at});
  }
}

Occupancy ink_of(const PanelLayout& layout) {
  Occupancy ink(layout.window.width, layout.window.height);
  for (const Trace& trace : layout.traces) {
    for (const Stroke& stroke : trace.strokes) {
      for (std::size_t i = 0; i + 1 < stroke.size(); ++i) ink.mark(stroke[i], stroke[i + 1]);
    }
    for (const Point dot : trace.dots) ink.mark(Box{dot.x, dot.y, 0, 0}.grown(mark_radius));
    for (const Exit& exit : trace.exits) {
      ink.mark(Box{exit.x - exit_mark / 2, exit.above ? 0 : layout.window.height - exit_mark, exit_mark, exit_mark});
    }
  }
  for (const double y : layout.lines) ink.mark({0, y}, {layout.window.width, y});
  return ink;
}

// All that names on lines must keep off.
std::vector<Stroke> drawn(const PanelLayout& layout) {
  std::vector<Stroke> strokes = layout.contour;
  for (const Trace& trace : layout.traces) {
    strokes.insert(strokes.end(), trace.strokes.begin(), trace.strokes.end());
    for (const Point dot : trace.dots) strokes.push_back({{dot.x - dot_radius, dot.y}, {dot.x + dot_radius, dot.y}});
  }
  for (const double y : layout.lines) strokes.push_back({{0, y}, {layout.window.width, y}});
  return strokes;
}

Occupancy shading_of(const PanelLayout& layout) {
  Occupancy shading(layout.window.width, layout.window.height);
  for (const Box& box : layout.limit_bands) shading.mark(box);
  for (const Box& box : layout.unreachable_bands) shading.mark(box);
  shading.seal();
  return shading;
}

// At the right end of its line, above it if that is free, else below; else further left. With no free place at all it stays at the right
// end.
Box place_label(const Extents& size, double y, const PanelLayout& layout, const Occupancy& ink) {
  const double width = layout.window.width, height = layout.window.height;
  const auto taken = [&](const Box& box) {
    return !ink.free(box) || std::any_of(layout.line_labels.begin(), layout.line_labels.end(),
                                         [&](const LineLabel& other) { return other.box.overlaps(box); });
  };
  std::optional<Box> fallback;
  for (double x = width - size.width - 2; x >= 2; x -= 4) {
    for (const double top : {y - size.height - line_label_gap, y + line_label_gap}) {
      if (top < 0 || top + size.height > height) continue;
      const Box box{x, top, size.width, size.height};
      if (!fallback) fallback = box;
      // The line itself is ink: the box asked about keeps a raster cell away from it.
      if (!taken({x, top < y ? top : top + 1.5, size.width, size.height - 1.5})) return box;
    }
  }
  return fallback.value_or(Box{2, std::clamp(y - size.height, 0.0, height - size.height), size.width, size.height});
}

void label_lines(cairo_t* cr, const Panel& panel, const Occupancy& ink, PanelLayout& layout) {
  layout.line_labels.clear();
  for (const Line& line : panel.lines) {
    if (line.label.empty() || !(line.y >= layout.y.low && line.y <= layout.y.high)) continue;
    const double y = to_page(layout.window, 0, line.y).y;
    layout.line_labels.push_back({line.label, place_label(measure(cr, line.label), y, layout, ink)});
  }
}

// Of those that this panel does not show.
std::string limits_note(const Panel& panel, const PanelLayout& layout) {
  std::vector<double> off;
  for (const Line& line : panel.lines)
    if (line.forbids != Line::Forbids::nothing && !(line.y >= layout.y.low && line.y <= layout.y.high)) off.push_back(line.y);
  return limits_off_scale(off, panel.y.unit);
}

// "▲ F₁ clipped, reaches 3.1×10⁵ N": which curves leave the frame on one side, and how far the farthest of them goes.
std::string note_of_side(const Panel& panel, const PanelLayout& layout, bool above) {
  int curves = 0;
  double farthest = above ? -largest : largest;
  std::string name;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const auto& exits = layout.traces[i].exits;
    if (std::none_of(exits.begin(), exits.end(), [&](const Exit& exit) { return exit.above == above; })) continue;
    ++curves;
    name = panel.series[i].label;
    for (const double y : panel.series[i].y) {
      if (std::isfinite(y)) farthest = above ? std::max(farthest, y) : std::min(farthest, y);
    }
  }
  if (curves == 0) return "";
  const std::string who = curves > 1 ? fmt::format("{} curves", curves) : name.empty() ? "curve" : name;
  return fmt::format("{} {} clipped, {} {}{}{}", above ? "▲" : "▼", who, curves > 1 ? "reach" : "reaches", typeset(farthest, 2),
                     panel.y.unit.empty() ? "" : " ", panel.y.unit);
}

std::string spike_note(const Panel& panel, const PanelLayout& layout) {
  std::string note;
  for (const std::string& part :
       {note_of_side(panel, layout, true), note_of_side(panel, layout, false), limits_note(panel, layout), panel.note})
    note += (note.empty() || part.empty() ? "" : "   ") + part;
  return note;
}

// Everything but the legend; returns the ground on which the legend looks for a place.
Ground arrange(cairo_t* cr, const Panel& panel, Interval y, double width, double height, PanelLayout& layout) {
  fill(panel, y, width, height, layout);
  layout.named = lay_out_named(cr, panel.named, layout.window, drawn(layout));
  Ground ground{ink_of(layout), shading_of(layout)};
  mark(ground.ink, layout.named);
  for (const DirectLabel& label : layout.direct.labels)
    if (label.inside) ground.ink.mark(label.box);
  Occupancy curves_and_lines = ground.ink;
  curves_and_lines.seal();
  label_lines(cr, panel, curves_and_lines, layout);
  for (const LineLabel& label : layout.line_labels) ground.ink.mark(label.box);
  ground.ink.seal();
  layout.spike_note = spike_note(panel, layout);
  return ground;
}

// Names that found no room on their lines are told by the legend, those that stand at their curves are not.
std::vector<Key> all_keys(const Panel& panel, const PanelLayout& layout) {
  std::vector<Key> keys = keys_of(panel);
  if (!layout.direct.labels.empty()) std::erase_if(keys, [](const Key& key) { return key.series >= 0; });
  for (std::size_t i = 0; i < panel.named.size(); ++i)
    if (const int dash = layout.named.lines[i].dash; dash > 0) keys.push_back({Key::Kind::named, panel.named[i].label, dash});
  return keys;
}

// The legend never covers a map.
void lay_out_map(cairo_t* cr, const Panel& panel, Interval y, double width, double height, double room, PanelLayout& layout) {
  const ColourMap& map = *panel.map;
  fill(panel, y, width, height, layout);
  layout.bar = lay_out_bar(cr, map, height);
  if (!map.contour.empty()) layout.contour = level_contour(map, layout.window);
  layout.named = lay_out_named(cr, panel.named, layout.window, drawn(layout));
  layout.spike_note = beyond_the_colours(map);
  const std::vector<Legend> shapes = legend_shapes(cr, all_keys(panel, layout), room);
  if (shapes.empty()) return;
  layout.legend_place = PanelLayout::Place::below;
  layout.legend = shapes.back();
}

// The range of y with which the curves bear their names themselves; none: the legend has them.
std::optional<Interval> name_curves(cairo_t* cr, const Panel& panel, Interval y, double width, double height, PanelLayout& layout) {
  if (!may_label_directly(panel)) return std::nullopt;
  for (const double headroom : {headrooms[0], headrooms[1]}) {
    const Interval range = headroom > 0 ? y_range(panel, headroom) : y;
    fill(panel, range, width, height, layout);
    std::optional<DirectLabels> found;
    if (headroom == 0) found = label_ends(cr, panel, layout.traces, layout.window);
    if (!found) found = label_inside(cr, panel, layout.traces, layout.lines, layout.window);
    if (!found) continue;
    layout.direct = std::move(*found);
    return range;
  }
  return std::nullopt;
}

}  // namespace

PanelLayout lay_out_panel(cairo_t* cr, const Panel& panel, double width, double height, double room, std::optional<Interval> shared) {
  PanelLayout layout;
  Interval x = x_range(panel), y = shared.value_or(y_range(panel));
  if (panel.equal) {
    const EqualFrame equal = fit_equal(x, y, width, height);
    width = equal.width, height = equal.height, x = equal.x, y = equal.y;
  }
  layout.frame = {0, 0, width, height};
  layout.empty = !has_data(panel);
  layout.x = horizontal_scale(cr, x, width);
  if (panel.map) {
    lay_out_map(cr, panel, y, width, height, room, layout);
    return layout;
  }
  if (shared) {
    const Ground ground = arrange(cr, panel, y, width, height, layout);
    layout.mark_labels = place_marks(cr, panel.marks, ground.ink, layout.window);
    layout.spike_note.clear();  // the marks say how far a curve goes that leaves the frame
    return layout;
  }
  const std::optional<Interval> named = name_curves(cr, panel, y, width, height, layout);
  std::vector<Interval> ranges;
  for (const double headroom : headrooms) ranges.push_back(headroom > 0 ? y_range(panel, headroom) : y);
  if (named) ranges = {*named};
  for (const Interval& range : ranges) {
    const Ground ground = arrange(cr, panel, range, width, height, layout);
    const std::vector<Legend> shapes = legend_shapes(cr, all_keys(panel, layout), width - 6);
    if (shapes.empty()) return layout;
    layout.legend_place = PanelLayout::Place::inside;
    if (place_inside(shapes, ground, width, height, layout.legend)) return layout;
    if (panel.equal) break;  // more room above would need another scale
  }
  arrange(cr, panel, ranges.front(), width, height, layout);
  layout.legend_place = PanelLayout::Place::below;
  layout.legend = legend_shapes(cr, all_keys(panel, layout), room).back();
  return layout;
}

}  // namespace pmreport::figure
