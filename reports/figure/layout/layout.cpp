#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/range.hpp>

#include <algorithm>
#include <cmath>

#include <reports/figure/palette.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {

std::string panel_letter(std::size_t i) {
  return i < 26 ? std::string(1, static_cast<char>('a' + i)) : panel_letter(i / 26 - 1) + panel_letter(i % 26);
}

namespace {

constexpr double millimetre = 72 / 25.4;  // [pt]
constexpr double column_width = 85 * millimetre;
constexpr double full_width = 174 * millimetre;
constexpr double between_columns = 11;  // [pt]
constexpr double between_rows = 9;
constexpr double legend_below = 3;  // [pt] from the axis title
constexpr int most_columns = 4;
constexpr double tallest = 250;  // [pt] of a frame to one scale

struct Grid {
  int columns;
  double width, cell_width, frame_height;  // [pt]; of frames that are free to have any
};

// About 48 mm a panel with its labels when two stand side by side; one alone is taller, so that it keeps its proportions. A
// map is about square.
Grid grid_of(const Figure& figure) {
  const double width = figure.width == Width::full ? full_width : column_width;
  const int wanted = figure.width == Width::full ? std::clamp(figure.columns, 1, most_columns) : 1;
  const int columns = std::max(1, std::min(wanted, static_cast<int>(figure.panels.size())));
  const double cell = (width - 2 * edge - between_columns * (columns - 1)) / columns;
  const bool maps = std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel& p) { return p.map.has_value(); });
  return {columns, width, cell, maps ? 150.0 : figure.width == Width::full && columns == 1 ? 140.0 : 102.0};
}

// Frames to one scale are as tall as their width makes them, and the others of their figure with them.
double frame_height(const Figure& figure, const Grid& grid, double width) {
  double tall = 0;
  for (const Panel& panel : figure.panels) {
    if (!panel.equal) continue;
    const Interval x = x_range(panel), y = y_range(panel);
    tall = std::max(tall, std::min(width * (y.high - y.low) / (x.high - x.low), tallest));
  }
  return tall > 0 ? std::max(tall, least_equal_height) : grid.frame_height;
}

// Room that a panel needs around its frame.
struct Margins {
  double left, right, bottom;  // [pt]
};

Margins margins_of(cairo_t* cr, const Panel& panel, PanelLayout& layout) {
  const auto size = [&](const std::string& text) { return Text(cr, text, {.size = tick_size}).extents(); };
  const double width = layout.frame.width, height = layout.frame.height;
  double widest = 0, overhang = 0;
  if (!layout.empty) {
    for (const Tick& tick : layout.y.major) widest = std::max(widest, size(tick.label).width);
  }
  for (const Tick& tick : layout.x.major) {
    overhang = std::max(overhang, layout.x.position(tick.value) * width + size(tick.label).width / 2 - width);
  }
  const double tick_height = size("0").height;
  const std::string x_title = axis_title(panel.x, layout.x), y_title = axis_title(panel.y, layout.y);
  const auto title_height = [&](const std::string& title, double room) {
    return title.empty() ? 0 : title_gap + Text(cr, title, {.size = label_size}, room).extents().height;
  };
  Margins margins{tick_length + tick_gap + widest + title_height(y_title, height), overhang,
                  tick_length + tick_gap + tick_height + title_height(x_title, width)};
  margins.right = std::max(margins.right, layout.direct.right);
  if (panel.map) margins.right = std::max(overhang, bar_width(cr, *panel.map, layout.bar, height));
  layout.x_title_y = height + tick_length + tick_gap + tick_height + title_gap;
  if (layout.legend_place == PanelLayout::Place::below) {
    layout.legend.box.y = height + margins.bottom + legend_below;
    margins.bottom += legend_below + layout.legend.box.height;
  }
  return margins;
}

std::string heading_of(const Figure& figure, std::size_t i) {
  const std::string title = escape_markup(figure.panels[i].title);
  if (figure.panels.size() < 2) return title;
  return "<b>(" + panel_letter(i) + ")</b>" + (title.empty() ? "" : "  " + title);
}

// Heading and note share a line when they fit.
double heading_height(cairo_t* cr, const PanelLayout& layout) {
  const double width = layout.frame.width;
  const Extents heading = Text(cr, layout.heading, {.size = title_size}, width, true).extents();
  double height = layout.heading.empty() ? 0 : heading.height;
  if (!layout.spike_note.empty()) {
    const Extents note = Text(cr, layout.spike_note, {.size = tick_size}, width).extents();
    const bool one_line = layout.heading.empty() || heading.width + note_distance + note.width <= width;
    height = one_line ? std::max(height, note.height) : height + note.height;
  }
  return height > 0 ? height + heading_gap : 0;
}

}  // namespace

Layout lay_out(cairo_t* cr, const Figure& figure) {
  if (figure.multiples) return lay_out_multiples(cr, figure, figure.width == Width::full ? full_width : column_width);
  const Grid grid = grid_of(figure);
  Layout layout;
  std::vector<Margins> margins(figure.panels.size());
  double left = 0, right = 0;
  // Margins depend on the numbers beside the axes, and these, a little, on the width that the margins leave.
  for (int round = 0; round < 3; ++round) {
    layout.panels.clear();
    double need_left = 0, need_right = 0;
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      const double room = grid.cell_width - left - right;
      layout.panels.push_back(lay_out_panel(cr, figure.panels[i], room, frame_height(figure, grid, room), grid.cell_width - right));
      layout.panels[i].heading = heading_of(figure, i);
      margins[i] = margins_of(cr, figure.panels[i], layout.panels[i]);
      need_left = std::max(need_left, margins[i].left);
      need_right = std::max(need_right, margins[i].right);
    }
    if (round > 0 && need_left <= left && need_right <= right) break;
    left = std::max(left, std::ceil(need_left));
    right = std::max(right, std::ceil(need_right));
  }

  double y = edge;
  const auto columns = static_cast<std::size_t>(grid.columns);
  for (std::size_t first = 0; first < layout.panels.size(); first += columns) {
    const std::size_t end = std::min(first + columns, layout.panels.size());
    double top = 0, below = 0;
    for (std::size_t i = first; i < end; ++i) {
      top = std::max(top, heading_height(cr, layout.panels[i]));
      below = std::max(below, layout.panels[i].frame.height + margins[i].bottom);
    }
    for (std::size_t i = first; i < end; ++i) {
      PanelLayout& panel = layout.panels[i];
      const double spare = grid.cell_width - left - right - panel.frame.width;  // of a frame to one scale
      panel.frame.x = edge + static_cast<double>(i - first) * (grid.cell_width + between_columns) + left + spare / 2;
      panel.frame.y = y + top;
      panel.y_title_x = -left;
      // In the middle below its frame, unless it is so wide that it would leave the panel on the right.
      Box& legend = panel.legend.box;
      if (panel.legend_place == PanelLayout::Place::below)
        legend.x = std::min((panel.frame.width - legend.width) / 2, panel.frame.width + spare / 2 - legend.width);
    }
    y += top + below + (end < layout.panels.size() ? between_rows : 0);
  }
  layout.size = {grid.width, std::ceil(y + edge)};
  return layout;
}

}  // namespace pmreport::figure
