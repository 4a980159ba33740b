#include <reports/figure/layout/legend.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <reports/figure/colour_map.hpp>
#include <reports/figure/colour_scale.hpp>
#include <reports/figure/layout/line_names.hpp>
#include <reports/figure/palette.hpp>
#include <reports/figure/parts.hpp>
#include <reports/figure/shading.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double swatch = 19;          // [pt] shows a whole period of every dash
constexpr double swatch_gap = 3;       // [pt] to its label
constexpr double column_gap = 8;       // [pt]
constexpr double padding = 2.5;        // [pt] around the keys
constexpr double box_clearance = 2.5;  // [pt] from the box to the nearest ink
constexpr double box_inset = 3;        // [pt] from the box to the frame
constexpr double box_pitch = 2;        // [pt] between the places tried
const Font font{.size = tick_size};

Text label_text(cairo_t* cr, const Key& key, double width) {
  Text text(cr, key.label, font, std::max(width, 1.0));
  pango_layout_set_height(text.layout(), -1);  // one line, however long the label
  pango_layout_set_ellipsize(text.layout(), PANGO_ELLIPSIZE_END);
  return text;
}

// Curves and shadings do not share a column: one is narrow, the other wide.
Legend shape(const std::vector<Key>& keys, const std::vector<Extents>& sizes, int rows) {
  Legend legend;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const bool shading_begins = i > 0 && rows > 1 && rows < static_cast<int>(keys.size()) && keys[i].kind != Key::Kind::curve &&
                                keys[i - 1].kind == Key::Kind::curve;
    if (legend.columns.empty() || shading_begins || static_cast<int>(legend.columns.back().keys.size()) == rows)
      legend.columns.emplace_back();
    Legend::Column& column = legend.columns.back();
    column.keys.push_back(keys[i]);
    legend.rows = std::max(legend.rows, static_cast<int>(column.keys.size()));
    column.width = std::max(column.width, swatch + swatch_gap + std::ceil(sizes[i].width + 0.5));
    legend.row_height = std::max(legend.row_height, std::ceil(sizes[i].height));
  }
  legend.box.width = 2 * padding + column_gap * static_cast<double>(legend.columns.size() - 1);
  for (const Legend::Column& column : legend.columns) legend.box.width += column.width;
  legend.box.height = legend.rows * legend.row_height + 2 * padding;
  return legend;
}

// Corners first, the top before the bottom and the right before the left; shading weighs as much as half the panel's size, a ragged last
// column as a small step away from the corner.
double cost(const Legend& legend, const Box& box, const Ground& ground, double width, double height) {
  const double left = box.x, right = width - box.right(), top = box.y, bottom = height - box.bottom();
  const double horizontal = std::min(right, left + 0.02 * width), vertical = std::min(top, bottom + 0.05 * height);
  const double from_corner = std::hypot(horizontal, vertical) / std::hypot(width, height);
  double unused = legend.rows * static_cast<double>(legend.columns.size());
  for (const Legend::Column& column : legend.columns) unused -= static_cast<double>(column.keys.size());
  return from_corner + 0.5 * ground.shading.share(box) + 0.04 * unused;
}

void draw_swatch(cairo_t* cr, const Key& key, double x, double middle) {
  if (key.kind == Key::Kind::fill) {
    draw_fill(cr, key.style, {x, middle - 3.25, swatch, 6.5});
  } else if (key.kind == Key::Kind::points || key.kind == Key::Kind::points_over_map) {
    set_colour(cr, (key.kind == Key::Kind::points ? line_style(key.style) : line_over_map(key.style)).colour);
    cairo_new_sub_path(cr);
    cairo_arc(cr, x + swatch / 2, middle, mark_radius, 0, 2 * std::numbers::pi);
    cairo_fill(cr);
  } else if (key.kind != Key::Kind::limit && key.kind != Key::Kind::unreachable) {
    const LineStyle style = key.kind == Key::Kind::curve      ? line_style(key.style)
                            : key.kind == Key::Kind::over_map ? line_over_map(key.style)
                            : key.kind == Key::Kind::named    ? LineStyle{ink, named_dash(key.style)}
                                                              : LineStyle{ink, {}};
    set_colour(cr, style.colour);
    cairo_set_line_width(cr, key.kind == Key::Kind::contour ? contour_width : key.kind == Key::Kind::named ? named_width : curve_width);
    cairo_set_dash(cr, style.dash.data(), static_cast<int>(style.dash.size()), 0);
    cairo_move_to(cr, x, middle);
    cairo_line_to(cr, x + swatch, middle);
    cairo_stroke(cr);
    cairo_set_dash(cr, nullptr, 0, 0);
  } else {
    shade(cr, {{x, middle - 2.75, swatch, 5.5}}, key.kind == Key::Kind::limit ? Band::Kind::limit : Band::Kind::unreachable);
  }
}

}  // namespace

int style_of(const Series& series, std::size_t position) { return series.style >= 0 ? series.style : static_cast<int>(position); }

std::vector<Key> keys_of(const Panel& panel) {
  std::vector<Key> keys;
  for (std::size_t i = 0; i < panel.series.size(); ++i) {
    const Key::Kind kind = panel.series[i].points ? (panel.map ? Key::Kind::points_over_map : Key::Kind::points)
                           : panel.map            ? Key::Kind::over_map
                                                  : Key::Kind::curve;
    if (!panel.series[i].label.empty()) keys.push_back({kind, panel.series[i].label, style_of(panel.series[i], i), static_cast<int>(i)});
  }
  const auto any = [&](Band::Kind kind) {
    return std::any_of(panel.bands.begin(), panel.bands.end(), [&](const Band& band) { return band.kind == kind; });
  };
  if (panel.map) {
    const auto& values = panel.map->values;
    const auto has = [&](auto&& is) { return std::any_of(values.begin(), values.end(), is); };
    if (panel.map->scale == ColourMap::Scale::classes) {
      for (std::size_t k = 0; k < panel.map->classes.size(); ++k)
        if (has([&](double v) { return v >= 0 && static_cast<std::size_t>(v) == k; }))
          keys.push_back({Key::Kind::fill, panel.map->classes[k], static_cast<int>(k)});
      if (has([](double v) { return !(v >= 0); })) keys.push_back({Key::Kind::fill, panel.map->missing, -1});
      return keys;
    }
    const double level = panel.map->level;
    if (!panel.map->contour.empty() && has([&](double v) { return v < level; }) && has([&](double v) { return v > level; }))
      keys.push_back({Key::Kind::contour, panel.map->contour});
    if (has([](double v) { return !std::isfinite(v); })) keys.push_back({Key::Kind::fill, panel.map->missing, -1});
    return keys;
  }
  if (any(Band::Kind::limit)) keys.push_back({Key::Kind::limit, "limit broken"});
  if (any(Band::Kind::unreachable)) keys.push_back({Key::Kind::unreachable, "out of reach"});
  return keys;
}

std::vector<Legend> legend_shapes(cairo_t* cr, const std::vector<Key>& keys, double width) {
  if (keys.empty()) return {};
  const double widest_label = width - swatch - swatch_gap - 2 * padding - 1;
  std::vector<Extents> sizes;
  for (const Key& key : keys) sizes.push_back(label_text(cr, key, widest_label).extents());
  std::vector<Legend> shapes;
  for (int rows = static_cast<int>(keys.size()); rows >= 1; --rows) {
    Legend legend = shape(keys, sizes, rows);
    if (!shapes.empty() && legend.box.width > width) continue;
    if (shapes.empty() || legend.columns.size() > shapes.back().columns.size())
      shapes.push_back(std::move(legend));
    else if (shapes.size() > 1 && legend.columns.size() == shapes.back().columns.size())
      shapes.back() = std::move(legend);  // the same columns, less uneven
  }
  return shapes;
}

bool place_inside(const std::vector<Legend>& shapes, const Ground& ground, double width, double height, Legend& placed) {
  double best = std::numeric_limits<double>::infinity();
  for (const Legend& legend : shapes) {
    const double last_x = width - box_inset - legend.box.width, last_y = height - box_inset - legend.box.height;
    for (double y = box_inset; y <= last_y; y = y < last_y ? std::min(y + box_pitch, last_y) : height) {
      for (double x = box_inset; x <= last_x; x = x < last_x ? std::min(x + box_pitch, last_x) : width) {
        const Box box{x, y, legend.box.width, legend.box.height};
        if (!ground.ink.free(box.grown(box_clearance))) continue;
        const double price = cost(legend, box, ground, width, height);
        if (price >= best) continue;
        best = price;
        placed = legend;
        placed.box = box;
      }
    }
  }
  return std::isfinite(best);
}

void draw_legend(cairo_t* cr, const Legend& legend, bool boxed) {
  if (boxed) {
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_rectangle(cr, legend.box.x, legend.box.y, legend.box.width, legend.box.height);
    cairo_fill_preserve(cr);
    set_colour(cr, border_ink);
    cairo_set_line_width(cr, grid_width);
    cairo_stroke(cr);
  }
  double x = legend.box.x + padding;
  for (const Legend::Column& column : legend.columns) {
    double top = legend.box.y + padding;
    for (const Key& key : column.keys) {
      if (key.series >= 0) begin_part(cr, fmt::format("class=\"key\" data-series=\"{}\"", key.series));
      draw_swatch(cr, key, x, top + legend.row_height / 2);
      set_colour(cr, ink);
      label_text(cr, key, column.width - swatch - swatch_gap).show(x + swatch + swatch_gap, top);
      if (key.series >= 0) end_part(cr);
      top += legend.row_height;
    }
    x += column.width + column_gap;
  }
}

}  // namespace pmreport::figure
