#include <fmt/format.h>
#include <pango/pangocairo.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/marks.hpp>
#include <reports/figure/palette.hpp>
#include <reports/figure/parts.hpp>
#include <reports/figure/shading.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double minor_tick_length = 1.4;  // [pt]

void line(cairo_t* cr, double x0, double y0, double x1, double y1) {
  cairo_move_to(cr, x0, y0);
  cairo_line_to(cr, x1, y1);
}

double across(const PanelLayout& layout, double x) { return layout.frame.width * layout.x.position(x); }
double down(const PanelLayout& layout, double y) { return layout.frame.height * (1 - layout.y.position(y)); }

void draw_grid(cairo_t* cr, const Panel& panel, const PanelLayout& layout) {
  const double width = layout.frame.width, height = layout.frame.height;
  for (const Tick& tick : layout.x.major) line(cr, across(layout, tick.value), 0, across(layout, tick.value), height);
  for (const Tick& tick : layout.y.major) line(cr, 0, down(layout, tick.value), width, down(layout, tick.value));
  set_colour(cr, grid_ink);
  cairo_set_line_width(cr, grid_width);
  cairo_stroke(cr);
  if (panel.y.names.empty() && layout.y.low < 0 && layout.y.high > 0) {
    line(cr, 0, down(layout, 0), width, down(layout, 0));
    set_colour(cr, zero_ink);
    cairo_set_line_width(cr, axis_width);
    cairo_stroke(cr);
  }
}

void draw_axes(cairo_t* cr, const PanelLayout& layout) {
  const double width = layout.frame.width, height = layout.frame.height;
  cairo_rectangle(cr, 0, 0, width, height);
  for (const Tick& tick : layout.x.major) line(cr, across(layout, tick.value), height, across(layout, tick.value), height + tick_length);
  for (const double x : layout.x.minor) line(cr, across(layout, x), height, across(layout, x), height + minor_tick_length);
  if (!layout.empty) {
    for (const Tick& tick : layout.y.major) line(cr, 0, down(layout, tick.value), -tick_length, down(layout, tick.value));
    for (const double y : layout.y.minor) line(cr, 0, down(layout, y), -minor_tick_length, down(layout, y));
  }
  set_colour(cr, ink);
  cairo_set_line_width(cr, axis_width);
  cairo_stroke(cr);
}

void draw_numbers(cairo_t* cr, const PanelLayout& layout) {
  const Font font{.size = tick_size};
  for (const Tick& tick : layout.x.major) {
    if (!layout.x_numbered) break;
    const Text text(cr, tick.label, font);
    text.show(across(layout, tick.value) - text.extents().width / 2, layout.frame.height + tick_length + tick_gap);
  }
  if (layout.empty) return;
  for (const Tick& tick : layout.y.major) {
    const Text text(cr, tick.label, font);
    const Extents size = text.extents();
    // Digits of DejaVu are 0.729 em tall: their middle, not that of the line, stands beside the tick.
    text.show(-tick_length - tick_gap - size.width, down(layout, tick.value) - size.baseline + 0.729 * tick_size / 2);
  }
}

void draw_titles(cairo_t* cr, const Panel& panel, const PanelLayout& layout) {
  const auto centred = [&](const std::string& title, double width) {
    Text text(cr, title, {.size = label_size}, width);
    pango_layout_set_alignment(text.layout(), PANGO_ALIGN_CENTER);
    return text;
  };
  if (layout.x_titled) centred(axis_title(panel.x, layout.x), layout.frame.width).show(0, layout.x_title_y);
  if (!layout.row_name.empty()) {
    const Text name(cr, "<b>" + escape_markup(layout.row_name) + "</b>", {.size = title_size}, 0, true);
    set_colour(cr, as_text(line_style(layout.row_style).colour));
    name.show(layout.row_name_x, (layout.frame.height - name.extents().height) / 2);
    set_colour(cr, ink);
  }
  if (!layout.y_titled) return;
  cairo_save(cr);
  cairo_translate(cr, layout.y_title_x, layout.frame.height);
  cairo_rotate(cr, -std::numbers::pi / 2);
  centred(axis_title(panel.y, layout.y), layout.frame.height).show(0, 0);
  cairo_restore(cr);
}

void draw_heading(cairo_t* cr, const PanelLayout& layout) {
  const double width = layout.frame.width;
  double y = -heading_gap;
  const Text note(cr, layout.spike_note, {.size = tick_size}, width);
  pango_layout_set_alignment(note.layout(), PANGO_ALIGN_RIGHT);
  const Text heading(cr, layout.heading, {.size = title_size}, width, true);
  const Extents note_size = note.extents(), heading_size = heading.extents();
  if (!layout.spike_note.empty()) {
    set_colour(cr, quiet_ink);
    note.show(0, y - note_size.height);
    const bool one_line = heading_size.width + note_distance + note_size.width <= width;
    if (!one_line) y -= note_size.height;
  }
  set_colour(cr, ink);
  heading.show(0, y - heading_size.height);
}

void draw_lines(cairo_t* cr, const PanelLayout& layout) {
  const double dash[] = {3, 1.6};
  for (const double y : layout.lines) line(cr, 0, y, layout.frame.width, y);
  set_colour(cr, quiet_ink);
  cairo_set_line_width(cr, limit_width);
  cairo_set_dash(cr, dash, 2, 0);
  cairo_stroke(cr);
  cairo_set_dash(cr, nullptr, 0, 0);
}

void draw_line_labels(cairo_t* cr, const PanelLayout& layout) {
  for (const LineLabel& label : layout.line_labels) {
    clear_ground(cr, label.box);
    set_colour(cr, quiet_ink);
    Text(cr, label.text, {.size = tick_size}).show(label.box.x, label.box.y);
  }
}

// A triangle on the frame, pointing out, where a curve is cut off; marks of one curve that would overlap are one.
void draw_exits(cairo_t* cr, const Trace& trace, double height) {
  double last[2] = {-1e9, -1e9};
  for (const Exit& exit : trace.exits) {
    double& previous = last[exit.above ? 1 : 0];
    if (std::abs(exit.x - previous) < exit_mark) continue;
    previous = exit.x;
    const double tip = exit.above ? 0 : height, inward = exit.above ? exit_mark : -exit_mark;
    cairo_move_to(cr, exit.x, tip);
    cairo_line_to(cr, exit.x - exit_mark / 2, tip + inward);
    cairo_line_to(cr, exit.x + exit_mark / 2, tip + inward);
    cairo_close_path(cr);
  }
  cairo_fill(cr);
}

void draw_curve(cairo_t* cr, const Trace& trace, const LineStyle& style, double radius, double height) {
  set_colour(cr, style.colour);
  cairo_set_line_width(cr, curve_width);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_dash(cr, style.dash.data(), static_cast<int>(style.dash.size()), 0);
  for (const Stroke& stroke : trace.strokes) {
    cairo_new_sub_path(cr);
    for (const Point p : stroke) cairo_line_to(cr, p.x, p.y);
  }
  cairo_stroke(cr);
  cairo_set_dash(cr, nullptr, 0, 0);
  for (const Point dot : trace.dots) {
    cairo_new_sub_path(cr);
    cairo_arc(cr, dot.x, dot.y, radius, 0, 2 * std::numbers::pi);
  }
  cairo_fill(cr);
  draw_exits(cr, trace, height);
}

// A light rim sets a curve off from whatever colour the map has there.
void draw_casing(cairo_t* cr, const Trace& trace, double radius) {
  for (const Stroke& stroke : trace.strokes) {
    cairo_new_sub_path(cr);
    for (const Point p : stroke) cairo_line_to(cr, p.x, p.y);
  }
  cairo_set_source_rgba(cr, 1, 1, 1, 0.8);
  cairo_set_line_width(cr, curve_width + 1.4);
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke(cr);
  for (const Point dot : trace.dots) {
    cairo_new_sub_path(cr);
    cairo_arc(cr, dot.x, dot.y, radius + 0.7, 0, 2 * std::numbers::pi);
  }
  cairo_fill(cr);
}

void draw_absence(cairo_t* cr, const PanelLayout& layout) {
  const Text text(cr, "no data", {.size = label_size});
  set_colour(cr, quiet_ink);
  text.show((layout.frame.width - text.extents().width) / 2, (layout.frame.height - text.extents().height) / 2);
}

}  // namespace

void draw_panel(cairo_t* cr, const Panel& panel, const PanelLayout& layout) {
  const Box& frame = layout.frame;
  begin_part(cr, fmt::format("class=\"panel\" data-frame=\"{:.2f} {:.2f} {:.2f} {:.2f}\" data-x=\"{} {}\" data-y=\"{} {}\"", frame.x,
                             frame.y, frame.width, frame.height, layout.x.low, layout.x.high, layout.y.low, layout.y.high));
  cairo_save(cr);
  cairo_translate(cr, frame.x, frame.y);
  if (panel.map) draw_map(cr, *panel.map, layout.window);
  shade(cr, layout.unreachable_bands, Band::Kind::unreachable);
  shade(cr, layout.limit_bands, Band::Kind::limit);
  if (!layout.empty && !panel.map) draw_grid(cr, panel, layout);
  draw_lines(cr, layout);
  const bool inside = layout.legend_place == PanelLayout::Place::inside;
  if (inside) draw_legend(cr, layout.legend, true);
  if (panel.map) draw_contour(cr, layout.contour);
  draw_named(cr, layout.named);
  draw_axes(cr, layout);
  for (std::size_t i = 0; i < layout.traces.size(); ++i) {
    const Series& series = panel.series[i];
    const double radius = series.points ? mark_radius : dot_radius;
    const int style = style_of(series, i);
    begin_part(cr, fmt::format("class=\"curve\" data-series=\"{}\"", i));
    if (panel.map) draw_casing(cr, layout.traces[i], radius);
    draw_curve(cr, layout.traces[i], panel.map ? line_over_map(style) : line_style(style), radius, frame.height);
    end_part(cr);
  }
  draw_line_labels(cr, layout);
  draw_direct_labels(cr, layout.direct);
  draw_marks(cr, panel.marks, layout.mark_labels, layout.window);
  draw_names(cr, layout.named);
  if (layout.empty) draw_absence(cr, layout);
  if (layout.legend_place == PanelLayout::Place::below) draw_legend(cr, layout.legend, false);
  set_colour(cr, ink);
  draw_numbers(cr, layout);
  draw_titles(cr, panel, layout);
  draw_heading(cr, layout);
  if (panel.map) draw_bar(cr, *panel.map, layout.bar, frame.width + bar_gap, frame.height);
  cairo_restore(cr);
  end_part(cr);
}

}  // namespace pmreport::figure
