#include "reports/figure/legend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "reports/figure/palette.hpp"
#include "reports/figure/shading.hpp"
#include "reports/figure/text.hpp"

namespace pmreport::figure {
namespace {

constexpr double swatch = 19;      // [pt] shows a whole period of every dash
constexpr double swatch_gap = 3;   // [pt] to its label
constexpr double column_gap = 8;   // [pt]
constexpr double padding = 2.5;    // [pt] around the keys
constexpr double clearance = 2.5;  // [pt] from the box to the nearest ink
constexpr double inset = 3;        // [pt] from the box to the frame
constexpr double pitch = 2;        // [pt] between the places tried
const Font font{.size = tick_size};

Text label_text(cairo_t* cr, const Key& key, double width) {
  Text text(cr, key.label, font, std::max(width, 1.0));
  pango_layout_set_height(text.layout(), -1);  // one line, however long the label
  pango_layout_set_ellipsize(text.layout(), PANGO_ELLIPSIZE_END);
  return text;
}

Legend shape(const std::vector<Key>& keys, const std::vector<Extents>& sizes, int columns) {
  const int count = static_cast<int>(keys.size());
  Legend legend;
  legend.keys = keys;
  legend.rows = (count + columns - 1) / columns;
  for (int first = 0; first < count; first += legend.rows) {
    double widest = 0;
    for (int i = first; i < std::min(count, first + legend.rows); ++i) widest = std::max(widest, sizes[static_cast<std::size_t>(i)].width);
    legend.column_widths.push_back(swatch + swatch_gap + std::ceil(widest + 0.5));
  }
  for (const Extents& size : sizes) legend.row_height = std::max(legend.row_height, size.height);
  legend.row_height = std::ceil(legend.row_height);
  legend.box.width = std::accumulate(legend.column_widths.begin(), legend.column_widths.end(), 2 * padding) +
                     column_gap * static_cast<double>(legend.column_widths.size() - 1);
  legend.box.height = legend.rows * legend.row_height + 2 * padding;
  return legend;
}

// Corners first, the top before the bottom and the right before the left; shading weighs as much as half the panel's size, a ragged last
// column as a small step away from the corner.
double cost(const Legend& legend, const Box& box, const Ground& ground, double width, double height) {
  const double left = box.x, right = width - box.right(), top = box.y, bottom = height - box.bottom();
  const double horizontal = std::min(right, left + 0.02 * width), vertical = std::min(top, bottom + 0.05 * height);
  const double from_corner = std::hypot(horizontal, vertical) / std::hypot(width, height);
  const double unused = legend.rows * static_cast<double>(legend.column_widths.size()) - static_cast<double>(legend.keys.size());
  return from_corner + 0.5 * ground.shading.share(box) + 0.04 * unused;
}

void draw_swatch(cairo_t* cr, const Key& key, double x, double middle) {
  if (key.kind == Key::Kind::curve) {
    const LineStyle style = line_style(key.style);
    set_colour(cr, style.colour);
    cairo_set_line_width(cr, curve_width);
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
    if (!panel.series[i].label.empty()) keys.push_back({Key::Kind::curve, panel.series[i].label, style_of(panel.series[i], i)});
  }
  const auto any = [&](Band::Kind kind) {
    return std::any_of(panel.bands.begin(), panel.bands.end(), [&](const Band& band) { return band.kind == kind; });
  };
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
  for (int columns = 1; columns <= static_cast<int>(keys.size()); ++columns) {
    Legend legend = shape(keys, sizes, columns);
    if (static_cast<int>(legend.column_widths.size()) < columns) continue;  // as many rows as before: seen already
    if (columns > 1 && legend.box.width > width) continue;
    shapes.push_back(std::move(legend));
  }
  return shapes;
}

bool place_inside(const std::vector<Legend>& shapes, const Ground& ground, double width, double height, Legend& placed) {
  double best = std::numeric_limits<double>::infinity();
  for (const Legend& legend : shapes) {
    const double last_x = width - inset - legend.box.width, last_y = height - inset - legend.box.height;
    for (double y = inset; y <= last_y; y = y < last_y ? std::min(y + pitch, last_y) : height) {
      for (double x = inset; x <= last_x; x = x < last_x ? std::min(x + pitch, last_x) : width) {
        const Box box{x, y, legend.box.width, legend.box.height};
        if (!ground.ink.free(box.grown(clearance))) continue;
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

void draw_legend(cairo_t* cr, const Legend& legend, bool opaque) {
  if (opaque) {
    cairo_set_source_rgb(cr, 1, 1, 1);
    cairo_rectangle(cr, legend.box.x, legend.box.y, legend.box.width, legend.box.height);
    cairo_fill(cr);
  }
  double x = legend.box.x + padding;
  for (std::size_t column = 0; column < legend.column_widths.size(); ++column) {
    for (int row = 0; row < legend.rows; ++row) {
      const std::size_t i = column * static_cast<std::size_t>(legend.rows) + static_cast<std::size_t>(row);
      if (i >= legend.keys.size()) break;
      const double top = legend.box.y + padding + row * legend.row_height;
      draw_swatch(cr, legend.keys[i], x, top + legend.row_height / 2);
      set_colour(cr, ink);
      label_text(cr, legend.keys[i], legend.column_widths[column] - swatch - swatch_gap).show(x + swatch + swatch_gap, top);
    }
    x += legend.column_widths[column] + column_gap;
  }
}

}  // namespace pmreport::figure
