#include <reports/figure/layout/marks.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <reports/figure/palette.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {
namespace {

constexpr double from_point = 2.6;  // [pt] from a point's middle to its number
constexpr double inset = 1;         // [pt] from a number to the frame

Text text_of(cairo_t* cr, const Mark& mark) {
  const std::string plain = escape_markup(mark.label);
  return Text(cr, mark.strong ? "<b>" + plain + "</b>" : plain, {.size = tick_size}, 0, true);
}

bool inside(Point p, const Frame& frame) { return Box{0, 0, frame.width, frame.height}.contains(p); }

// A curve that leaves the frame is marked where it does: its number says how far it goes.
Point place_of(const Mark& mark, const Frame& frame) {
  const Point at = to_page(frame, mark.x, mark.y);
  return {at.x, std::clamp(at.y, 0.0, frame.height)};
}

}  // namespace

std::vector<Box> place_marks(cairo_t* cr, const std::vector<Mark>& marks, const Occupancy& ink, const Frame& frame) {
  std::vector<Box> out;
  for (const Mark& mark : marks) {
    const Point at = place_of(mark, frame);
    out.push_back({at.x, at.y, 0, 0});
    if (!inside(at, frame)) continue;
    const Extents size = text_of(cr, mark).extents();
    const double w = size.width, h = size.height - 1.5;
    double least = std::numeric_limits<double>::infinity();
    // Rings about the point, the nearest first: farther costs as much as a little ink.
    for (const double far : {0.0, 3.0, 7.0, 12.0})
      for (int way = 0; way < 16; ++way) {
        const double angle = way * std::numbers::pi / 8, c = std::cos(angle), s = std::sin(angle);
        Box box{at.x + c * (w / 2 + from_point + far) - w / 2, at.y + s * (h / 2 + from_point + far) - h / 2, w, h};
        box.x = std::clamp(box.x, inset, std::max(inset, frame.width - inset - w));
        box.y = std::clamp(box.y, inset, std::max(inset, frame.height - inset - h));
        const Box own = Box{at.x, at.y, 0, 0}.grown(mark_radius);
        const bool covered = box.overlaps(own) || std::any_of(out.begin(), out.end() - 1, [&](const Box& b) { return b.overlaps(box); });
        const double cost = ink.share(box) + 0.01 * far + (covered ? 10 : 0);
        if (cost < least) least = cost, out.back() = box;
      }
  }
  return out;
}

void draw_marks(cairo_t* cr, const std::vector<Mark>& marks, const std::vector<Box>& places, const Frame& frame) {
  for (std::size_t i = 0; i < std::min(marks.size(), places.size()); ++i) {
    const Point at = place_of(marks[i], frame);
    if (!inside(at, frame)) continue;
    const Colour colour = line_style(marks[i].style).colour;
    cairo_new_sub_path(cr);
    cairo_arc(cr, at.x, at.y, mark_radius, 0, 2 * std::numbers::pi);
    set_colour(cr, colour);
    cairo_fill(cr);
    const Text text = text_of(cr, marks[i]);
    clear_ground(cr, places[i]);
    set_colour(cr, as_text(colour));
    text.show(places[i].x, places[i].y - 0.75);
  }
}

}  // namespace pmreport::figure
