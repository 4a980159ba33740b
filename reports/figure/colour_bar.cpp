#include <reports/figure/colour_bar.hpp>

#include <algorithm>
#include <numbers>

#include <reports/figure/colour_scale.hpp>
#include <reports/figure/layout/layout.hpp>
#include <reports/figure/palette.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double thickness = 9;  // [pt] of the bar

}  // namespace

ColourBar lay_out_bar(cairo_t* cr, const ColourMap& map, double height) {
  if (map.scale == ColourMap::Scale::classes) return {};
  const Interval range = colour_range(map);
  ColourBar bar{make_scale(range.low, range.high, std::max(3, static_cast<int>(height / 24)))};
  for (const Tick& tick : bar.scale.major) bar.widest = std::max(bar.widest, Text(cr, tick.label, {.size = tick_size}).extents().width);
  return bar;
}

double bar_width(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double height) {
  if (map.scale == ColourMap::Scale::classes) return 0;
  const std::string title = axis_title(map.bar, bar.scale);
  const double title_height = title.empty() ? 0 : title_gap + Text(cr, title, {.size = label_size}, height).extents().height;
  return bar_gap + thickness + tick_length + tick_gap + bar.widest + title_height;
}

void draw_bar(cairo_t* cr, const ColourMap& map, const ColourBar& bar, double left, double height) {
  if (map.scale == ColourMap::Scale::classes) return;
  for (int k = 0; k < colour_levels; ++k) {
    set_colour(cr, colour_of(map, {0, colour_levels}, k + 0.5));
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
