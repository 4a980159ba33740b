#include <reports/figure/colour_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <reports/figure/colour_scale.hpp>
#include <reports/figure/contour.hpp>
#include <reports/figure/surface.hpp>

namespace pmreport::figure {
namespace {

std::uint32_t pixel(const Colour& c) {
  const auto byte = [](double x) { return static_cast<std::uint32_t>(std::lround(255 * x)); };
  return 0xff000000U | byte(c.red) << 16 | byte(c.green) << 8 | byte(c.blue);
}

// The values at the corners of a cell, and how much each counts at a place in it.
struct Cell {
  std::array<double, 4> value{}, weight{};
};

// At (u, v): columns and rows counted from the first as fractions.
Cell cell_at(const ColourMap& map, double u, double v) {
  const std::size_t columns = map.x.size(), rows = map.y.size();
  const auto corner = [](double at, std::size_t count) {
    return std::min(static_cast<std::size_t>(std::max(at, 0.0)), count > 1 ? count - 2 : 0);
  };
  const std::size_t i = corner(u, columns), j = corner(v, rows);
  const double a = std::clamp(u - static_cast<double>(i), 0.0, 1.0), b = std::clamp(v - static_cast<double>(j), 0.0, 1.0);
  const auto at = [&](std::size_t column, std::size_t row) {
    return map.values[std::min(row, rows - 1) * columns + std::min(column, columns - 1)];
  };
  return {{at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)}, {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b}};
}

// Bilinear among the finite corners, nothing where the nearest corner has no value.
double value_at(const Cell& cell) {
  const auto nearest = std::max_element(cell.weight.begin(), cell.weight.end()) - cell.weight.begin();
  if (!std::isfinite(cell.value[static_cast<std::size_t>(nearest)])) return std::nan("");
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < 4; ++k)
    if (std::isfinite(cell.value[k])) sum += cell.weight[k] * cell.value[k], weight += cell.weight[k];
  return sum / weight;
}

// The class that counts most: borders between classes run straight through cells, not along their edges.
int class_at(const Cell& cell) {
  const auto number = [](double value) { return value >= 0 ? static_cast<int>(std::min(value, 1e6)) : -1; };  // NaN: -1
  int best = -1;
  double most = -1;
  for (std::size_t k = 0; k < 4; ++k) {
    double weight = 0;
    for (std::size_t n = 0; n < 4; ++n)
      if (number(cell.value[n]) == number(cell.value[k])) weight += cell.weight[n];
    if (weight > most) most = weight, best = number(cell.value[k]);
  }
  return best;
}

template <class ColourAt>  // Colour(row, column, rows, columns)
void paint(cairo_t* cr, const Box& box, ColourAt&& colour_at) {
  const int columns = std::max(1, static_cast<int>(box.width * pixels_per_point)),
            rows = std::max(1, static_cast<int>(box.height * pixels_per_point));
  const Surface image{cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows)};
  unsigned char* data = cairo_image_surface_get_data(image.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
  for (int r = 0; r < rows; ++r) {
    auto* line = reinterpret_cast<std::uint32_t*>(data + static_cast<std::size_t>(r) * stride);
    for (int c = 0; c < columns; ++c) line[c] = pixel(colour_at(r, c, rows, columns));
  }
  cairo_surface_mark_dirty(image.get());
  cairo_save(cr);
  cairo_translate(cr, box.x, box.y);
  cairo_scale(cr, box.width / columns, box.height / rows);
  cairo_set_source_surface(cr, image.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
  cairo_paint(cr);
  cairo_restore(cr);
}

}  // namespace

std::vector<Stroke> level_contour(const ColourMap& map, const Frame& frame) {
  const double pole =
      map.scale == ColourMap::Scale::diverging ? colour_range(map).high - map.level : std::numeric_limits<double>::infinity();
  std::vector<double> above = map.values;
  for (double& v : above) v -= map.level;
  std::vector<Stroke> strokes = zero_lines(map.x, map.y, above, pole);
  for (Stroke& stroke : strokes)
    for (Point& p : stroke) p = to_page(frame, p.x, p.y);
  return strokes;
}

void draw_map(cairo_t* cr, const ColourMap& map, const Frame& frame) {
  const Point first = to_page(frame, map.x.front(), map.y.back()), last = to_page(frame, map.x.back(), map.y.front());
  const Interval range = colour_range(map);
  const bool classes = map.scale == ColourMap::Scale::classes;
  paint(cr, {first.x, first.y, last.x - first.x, last.y - first.y}, [&](int row, int column, int rows, int columns) {
    const Cell cell = cell_at(map, (column + 0.5) / columns * static_cast<double>(map.x.size() - 1),
                              (1 - (row + 0.5) / rows) * static_cast<double>(map.y.size() - 1));
    if (classes) return fill_of(class_at(cell), row, column);
    const double value = value_at(cell);
    return std::isfinite(value) ? colour_of(map, range, value) : fill_of(-1, row, column);
  });
}

void draw_fill(cairo_t* cr, int number, const Box& box) {
  paint(cr, box, [&](int row, int column, int, int) { return fill_of(number, row, column); });
}

void draw_contour(cairo_t* cr, const std::vector<Stroke>& contour) {
  cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  for (const Stroke& stroke : contour) {
    cairo_move_to(cr, stroke[0].x, stroke[0].y);
    for (std::size_t i = 1; i < stroke.size(); ++i) cairo_line_to(cr, stroke[i].x, stroke[i].y);
  }
  set_colour(cr, ink);
  cairo_set_line_width(cr, contour_width);
  cairo_stroke(cr);
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
}

}  // namespace pmreport::figure
