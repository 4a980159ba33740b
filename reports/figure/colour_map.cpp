#include <reports/figure/colour_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>

#include <reports/figure/layout/layout.hpp>
#include <reports/figure/surface.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double thickness = 9;         // [pt] of the bar
constexpr double pixels_per_point = 3;  // 216 a inch: steps of colour look straight in print
constexpr double inside_quantile = 0.98;
constexpr Colour out_of_reach{0.80, 0.80, 0.80}, hatch{0.66, 0.66, 0.66};
constexpr int hatch_pitch = 12, hatch_line = 2;  // [px]

double level_of(double value, double limit) {
  const double share = std::clamp(value / limit, -1.0, 1.0), step = 2.0 / colour_levels;
  return std::clamp((std::floor(share / step) + 0.5) * step, -1 + step / 2, 1 - step / 2);
}

std::uint32_t pixel(const Colour& c) {
  const auto byte = [](double x) { return static_cast<std::uint32_t>(std::lround(255 * x)); };
  return 0xff000000U | byte(c.red) << 16 | byte(c.green) << 8 | byte(c.blue);
}

// The value at (u, v), columns and rows counted from the first as fractions: bilinear among the finite corners of its cell, nothing where
// the nearest corner has none.
double value_at(const ColourMap& map, double u, double v) {
  const std::size_t columns = map.x.size(), rows = map.y.size();
  const auto corner = [](double at, std::size_t count) {
    return std::min(static_cast<std::size_t>(std::max(at, 0.0)), count > 1 ? count - 2 : 0);
  };
  const std::size_t i = corner(u, columns), j = corner(v, rows);
  const double a = std::clamp(u - static_cast<double>(i), 0.0, 1.0), b = std::clamp(v - static_cast<double>(j), 0.0, 1.0);
  const auto at = [&](std::size_t column, std::size_t row) {
    return map.values[std::min(row, rows - 1) * columns + std::min(column, columns - 1)];
  };
  if (!std::isfinite(at(a < 0.5 ? i : i + 1, b < 0.5 ? j : j + 1))) return std::nan("");
  double sum = 0, weight = 0;
  for (const auto& [x, y, w] :
       {std::array{0.0, 0.0, (1 - a) * (1 - b)}, {1.0, 0.0, a * (1 - b)}, {0.0, 1.0, (1 - a) * b}, {1.0, 1.0, a * b}}) {
    const double value = at(i + static_cast<std::size_t>(x), j + static_cast<std::size_t>(y));
    if (std::isfinite(value)) sum += w * value, weight += w;
  }
  return sum / weight;
}

}  // namespace

Colour diverging(double value) {
  static constexpr std::array<Colour, 11> anchors{{{0.020, 0.188, 0.380},
                                                   {0.129, 0.400, 0.675},
                                                   {0.263, 0.576, 0.765},
                                                   {0.573, 0.773, 0.871},
                                                   {0.820, 0.898, 0.941},
                                                   {0.969, 0.969, 0.969},
                                                   {0.992, 0.859, 0.780},
                                                   {0.957, 0.647, 0.510},
                                                   {0.839, 0.376, 0.302},
                                                   {0.698, 0.094, 0.169},
                                                   {0.404, 0.000, 0.122}}};
  const double at = (std::clamp(value, -1.0, 1.0) + 1) / 2 * (anchors.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), anchors.size() - 2);
  const double share = at - static_cast<double>(i);
  const auto mix = [&](double Colour::*part) { return anchors[i].*part * (1 - share) + anchors[i + 1].*part * share; };
  return {mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue)};
}

double colour_limit(const ColourMap& map) {
  std::vector<double> all;
  for (const double v : map.values)
    if (std::isfinite(v)) all.push_back(std::min(std::abs(v), largest));
  if (all.empty()) return 1;
  const auto nth = all.begin() + static_cast<std::ptrdiff_t>(inside_quantile * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), nth, all.end());
  return *nth > 0 ? *nth : 1;
}

// Marching squares. A cell whose corners alternate in sign has two pieces; the sign of its middle tells which corners they cut off.
std::vector<Stroke> zero_contour(const ColourMap& map, const Frame& frame) {
  const std::size_t columns = map.x.size(), rows = map.y.size();
  const double limit = colour_limit(map);
  std::vector<Stroke> strokes;
  for (std::size_t j = 0; j + 1 < rows; ++j)
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::array<std::array<std::size_t, 2>, 4> corners{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      std::array<double, 4> v{};
      for (std::size_t k = 0; k < 4; ++k) v[k] = map.values[corners[k][1] * columns + corners[k][0]];
      if (!std::all_of(v.begin(), v.end(), [](double x) { return std::isfinite(x); })) continue;
      std::vector<Point> cuts;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t n = (k + 1) % 4;
        if ((v[k] < 0) == (v[n] < 0)) continue;
        if (std::min(std::abs(v[k]), std::abs(v[n])) > limit) continue;
        const double s = v[k] / (v[k] - v[n]);
        cuts.push_back(to_page(frame, map.x[corners[k][0]] * (1 - s) + map.x[corners[n][0]] * s,
                               map.y[corners[k][1]] * (1 - s) + map.y[corners[n][1]] * s));
      }
      if (cuts.size() == 2) strokes.push_back({cuts[0], cuts[1]});
      if (cuts.size() == 4) {
        const bool middle_like_first = (v[0] + v[1] + v[2] + v[3] < 0) == (v[0] < 0);
        strokes.push_back({cuts[0], cuts[middle_like_first ? 1 : 3]});
        strokes.push_back({cuts[2], cuts[middle_like_first ? 3 : 1]});
      }
    }
  // Where a corner is zero itself, cells around it meet in a point.
  const auto key = [](Point p) { return std::pair{std::lround(p.x * 1e6), std::lround(p.y * 1e6)}; };
  std::erase_if(strokes, [&](const Stroke& s) { return key(s.front()) == key(s.back()); });
  // Pieces that end where another begins become one stroke, so that line joins and dashes are those of a curve.
  std::multimap<std::pair<long, long>, std::size_t> ends;
  for (std::size_t k = 0; k < strokes.size(); ++k) ends.emplace(key(strokes[k].front()), k), ends.emplace(key(strokes[k].back()), k);
  std::vector<bool> used(strokes.size());
  std::vector<Stroke> joined;
  for (std::size_t k = 0; k < strokes.size(); ++k) {
    if (used[k]) continue;
    used[k] = true;
    Stroke line = strokes[k];
    for (int side = 0; side < 2; ++side) {
      for (bool grew = true; grew;) {
        grew = false;
        const auto [first, last] = ends.equal_range(key(line.back()));
        for (auto it = first; it != last && !grew; ++it) {
          if (used[it->second]) continue;
          const Stroke& next = strokes[it->second];
          line.push_back(key(next.front()) == key(line.back()) ? next.back() : next.front());
          used[it->second] = grew = true;
        }
      }
      std::reverse(line.begin(), line.end());
    }
    joined.push_back(line);
  }
  return joined;
}

void draw_map(cairo_t* cr, const ColourMap& map, double width, double height) {
  const int columns = std::max(1, static_cast<int>(width * pixels_per_point)),
            rows = std::max(1, static_cast<int>(height * pixels_per_point));
  const Surface image{cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows)};
  unsigned char* data = cairo_image_surface_get_data(image.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
  const double limit = colour_limit(map);
  for (int r = 0; r < rows; ++r) {
    auto* line = reinterpret_cast<std::uint32_t*>(data + static_cast<std::size_t>(r) * stride);
    for (int c = 0; c < columns; ++c) {
      const double u = (c + 0.5) / columns * static_cast<double>(map.x.size() - 1),
                   v = (1 - (r + 0.5) / rows) * static_cast<double>(map.y.size() - 1);
      const double value = value_at(map, u, v);
      line[c] = pixel(std::isfinite(value) ? diverging(level_of(value, limit)) : (r + c) % hatch_pitch < hatch_line ? hatch : out_of_reach);
    }
  }
  cairo_surface_mark_dirty(image.get());
  cairo_save(cr);
  cairo_scale(cr, width / columns, height / rows);
  cairo_set_source_surface(cr, image.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
  cairo_paint(cr);
  cairo_restore(cr);
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

ColourBar lay_out_bar(cairo_t* cr, const ColourMap& map, double height) {
  const double limit = colour_limit(map);
  ColourBar bar{make_scale(-limit, limit, std::max(3, static_cast<int>(height / 24)))};
  for (const Tick& tick : bar.scale.major) bar.widest = std::max(bar.widest, Text(cr, tick.label, {.size = tick_size}).extents().width);
  return bar;
}

double bar_width(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double height) {
  const std::string title = axis_title(map.bar, bar.scale);
  const double title_height = title.empty() ? 0 : title_gap + Text(cr, title, {.size = label_size}, height).extents().height;
  return bar_gap + thickness + tick_length + tick_gap + bar.widest + title_height;
}

void draw_bar(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double left, double height) {
  for (int k = 0; k < colour_levels; ++k) {
    set_colour(cr, diverging(-1 + (k + 0.5) * 2.0 / colour_levels));
    cairo_rectangle(cr, left, height * (1 - (k + 1.0) / colour_levels), thickness, height / colour_levels);
    cairo_fill(cr);
  }
  set_colour(cr, ink);
  cairo_set_line_width(cr, axis_width);
  cairo_rectangle(cr, left, 0, thickness, height);
  const double right = left + thickness;
  for (const Tick& tick : bar.scale.major) {
    const double y = height * (1 - bar.scale.position(tick.value));
    cairo_move_to(cr, right, y);
    cairo_line_to(cr, right + tick_length, y);
  }
  cairo_stroke(cr);
  for (const Tick& tick : bar.scale.major) {
    const Text text(cr, tick.label, {.size = tick_size});
    const Extents size = text.extents();
    const double y = height * (1 - bar.scale.position(tick.value));
    text.show(right + tick_length + tick_gap + bar.widest - size.width, y - size.baseline + 0.729 * tick_size / 2);
  }
  const Text title(cr, axis_title(map.bar, bar.scale), {.size = label_size}, height);
  pango_layout_set_alignment(title.layout(), PANGO_ALIGN_CENTER);
  cairo_save(cr);
  cairo_translate(cr, right + tick_length + tick_gap + bar.widest + title_gap, height);
  cairo_rotate(cr, -std::numbers::pi / 2);
  title.show(0, 0);
  cairo_restore(cr);
}

}  // namespace pmreport::figure
