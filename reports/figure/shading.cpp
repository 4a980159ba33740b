#include <reports/figure/shading.hpp>

#include <algorithm>
#include <cmath>

#include <reports/figure/palette.hpp>

namespace pmreport::figure {
namespace {

constexpr double thinnest = 1;       // [pt] a single sample must be seen
constexpr double hatch_pitch = 3.2;  // [pt] along x
constexpr double hatch_width = 0.35;

// Lines x + y = const of one common pattern: bands of a panel look like windows on one hatched ground.
void hatch(cairo_t* cr, const Box& box) {
  const double first = std::ceil((box.x + box.y) / hatch_pitch) * hatch_pitch;
  for (double sum = first; sum < box.right() + box.bottom(); sum += hatch_pitch) {
    const double left = std::max(box.x, sum - box.bottom()), right = std::min(box.right(), sum - box.y);
    cairo_move_to(cr, left, sum - left);
    cairo_line_to(cr, right, sum - right);
  }
}

}  // namespace

std::vector<Box> band_boxes(const std::vector<Band>& bands, Band::Kind kind, const Frame& frame) {
  std::vector<Interval> spans;
  for (const Band& band : bands) {
    if (band.kind != kind || !std::isfinite(band.from) || !std::isfinite(band.to)) continue;
    const double from = std::min(band.from, band.to), to = std::max(band.from, band.to);
    if (to < frame.x.low || from > frame.x.high) continue;
    double left = std::max(0.0, to_page(frame, from, 0).x), right = std::min(frame.width, to_page(frame, to, 0).x);
    if (right - left < thinnest) {
      left = std::clamp((left + right - thinnest) / 2, 0.0, frame.width - thinnest);
      right = left + thinnest;
    }
    spans.push_back({left, right});
  }
  std::sort(spans.begin(), spans.end(), [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::vector<Box> boxes;
  for (const Interval& span : spans) {
    if (!boxes.empty() && span.low <= boxes.back().right()) {
      boxes.back().width = std::max(boxes.back().right(), span.high) - boxes.back().x;
    } else {
      boxes.push_back({span.low, 0, span.high - span.low, frame.height});
    }
  }
  return boxes;
}

void shade(cairo_t* cr, const std::vector<Box>& boxes, Band::Kind kind) {
  if (boxes.empty()) return;
  const bool limit = kind == Band::Kind::limit;
  for (const Box& box : boxes) cairo_rectangle(cr, box.x, box.y, box.width, box.height);
  set_colour(cr, limit ? limit_tint : unreachable_tint);
  cairo_fill(cr);
  if (!limit) return;
  for (const Box& box : boxes) hatch(cr, box);
  set_colour(cr, limit_hatch);
  cairo_set_line_width(cr, hatch_width);
  cairo_stroke(cr);
}

}  // namespace pmreport::figure
