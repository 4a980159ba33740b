// Points and boxes on the page [pt], y downwards.
#pragma once

namespace pmreport::figure {

struct Point {
  double x, y;
};

struct Box {
  double x = 0, y = 0, width = 0, height = 0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  Box grown(double margin) const { return {x - margin, y - margin, width + 2 * margin, height + 2 * margin}; }
  bool contains(Point p) const { return p.x >= x && p.x <= right() && p.y >= y && p.y <= bottom(); }
  bool overlaps(const Box& other) const { return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom(); }
};

}  // namespace pmreport::figure
