#include <reports/figure/curve.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pmreport::figure {
namespace {

constexpr double column = 0.25;     // [pt] a sample column: below the finest printer's dot that a reader can tell
constexpr double tolerance = 0.03;  // [pt] 0.01 mm, a thirtieth of the curve's width
constexpr double far = 1e6;         // frame sizes: a segment to there leaves the frame as steeply as one to infinity

double distance2(Point p, Point a, Point b) {
  const double ux = b.x - a.x, uy = b.y - a.y;
  const double length2 = ux * ux + uy * uy;
  const double s = length2 > 0 ? std::clamp(((p.x - a.x) * ux + (p.y - a.y) * uy) / length2, 0.0, 1.0) : 0;
  const double dx = p.x - a.x - s * ux, dy = p.y - a.y - s * uy;
  return dx * dx + dy * dy;
}

// Liang and Barsky: p + s (q - p) is inside the box for s in [enter, leave].
bool clip_segment(Point& p, Point& q, const Box& box) {
  double enter = 0, leave = 1;
  const double dx = q.x - p.x, dy = q.y - p.y;
  const auto half_plane = [&](double along, double room) {  // along·s <= room
    if (along == 0) return room >= 0;
    (along > 0 ? leave : enter) = along > 0 ? std::min(leave, room / along) : std::max(enter, room / along);
    return enter <= leave;
  };
  if (!half_plane(-dx, p.x - box.x) || !half_plane(dx, box.right() - p.x) || !half_plane(-dy, p.y - box.y) ||
      !half_plane(dy, box.bottom() - p.y)) {
    return false;
  }
  const Point start = p;
  // The bounds once more: start + s·d misses them by rounding.
  const auto at = [&](double s) {
    return Point{std::clamp(start.x + s * dx, box.x, box.right()), std::clamp(start.y + s * dy, box.y, box.bottom())};
  };
  if (leave < 1) q = at(leave);
  if (enter > 0) p = at(enter);
  return true;
}

bool same(Point a, Point b) { return a.x == b.x && a.y == b.y; }

void add_exits(const Stroke& run, const Box& box, std::vector<Exit>& exits) {
  for (std::size_t i = 0; i < run.size();) {
    const bool above = run[i].y<box.y, below = run[i].y> box.bottom();
    if (!above && !below) {
      ++i;
      continue;
    }
    std::size_t farthest = i;
    for (; i < run.size() && (above ? run[i].y < box.y : run[i].y > box.bottom()); ++i) {
      if (above ? run[i].y < run[farthest].y : run[i].y > run[farthest].y) farthest = i;
    }
    exits.push_back({std::clamp(run[farthest].x, box.x, box.right()), above});
  }
}

void add_run(const Stroke& run, const Box& box, Trace& trace) {
  if (run.empty()) return;
  add_exits(run, box, trace.exits);
  if (std::all_of(run.begin(), run.end(), [&](Point p) { return same(p, run.front()); })) {
    if (box.contains(run.front())) trace.dots.push_back(run.front());
    return;
  }
  for (const Stroke& piece : clip(decimate(run, column), box)) trace.strokes.push_back(simplify(piece, tolerance));
}

}  // namespace

Point to_page(const Frame& frame, double x, double y) {
  const auto fraction = [](double value, const Interval& range) {
    return std::clamp((std::clamp(value, -largest, largest) - range.low) / (range.high - range.low), -far, far);
  };
  return {frame.width * fraction(x, frame.x), frame.height * (1 - fraction(y, frame.y))};
}

Trace trace(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame) {
  const Box box{0, 0, frame.width, frame.height};
  Trace result;
  Stroke run;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isfinite(x[i]) && std::isfinite(y[i])) {
      run.push_back(to_page(frame, x[i], y[i]));
    } else {
      add_run(run, box, result);
      run.clear();
    }
  }
  add_run(run, box, result);
  return result;
}

Trace trace_of_points(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame) {
  const Box box{0, 0, frame.width, frame.height};
  Trace result;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    if (const Point p = to_page(frame, x[i], y[i]); box.contains(p)) result.dots.push_back(p);
  }
  return result;
}

Stroke decimate(const Stroke& points, double column_width) {
  Stroke kept;
  for (std::size_t begin = 0; begin < points.size();) {
    const double bin = std::floor(points[begin].x / column_width);
    std::size_t low = begin, high = begin, end = begin;
    for (; end < points.size() && std::floor(points[end].x / column_width) == bin; ++end) {
      if (points[end].y < points[low].y) low = end;
      if (points[end].y > points[high].y) high = end;
    }
    std::size_t previous = begin;
    kept.push_back(points[begin]);
    for (const std::size_t next : {std::min(low, high), std::max(low, high), end - 1}) {
      if (next > previous) kept.push_back(points[next]);
      previous = std::max(previous, next);
    }
    begin = end;
  }
  return kept;
}

void thin_out(std::vector<double>& x, std::vector<double>& y) {
  const std::size_t n = std::min(x.size(), y.size());
  if (n < few_samples) return;
  const auto [low, high] = std::minmax_element(x.begin(), x.end());
  const double width = (*high - *low) / (few_samples / 4);  // four samples of each column are kept
  if (!(width > 0 && std::isfinite(width))) return;
  Stroke kept, run;
  const auto end_run = [&] {
    for (const Point& p : decimate(run, width)) kept.push_back(p);
    run.clear();
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(y[i])) {
      run.push_back({x[i], y[i]});
    } else if (i == 0 || std::isfinite(y[i - 1])) {
      end_run();
      kept.push_back({x[i], y[i]});
    }
  }
  end_run();
  x.assign(kept.size(), 0), y.assign(kept.size(), 0);
  for (std::size_t i = 0; i < kept.size(); ++i) x[i] = kept[i].x, y[i] = kept[i].y;
  x.shrink_to_fit(), y.shrink_to_fit();
}

Stroke simplify(const Stroke& points, double allowed) {
  if (points.size() < 3) return points;
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = allowed * allowed;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double miss = distance2(points[i], points[first], points[last]);
      if (miss > worst) {
        worst = miss;
        split = i;
      }
    }
    if (split == first) continue;
    keep[split] = true;
    open.emplace_back(first, split);
    open.emplace_back(split, last);
  }
  Stroke kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i]) kept.push_back(points[i]);
  }
  return kept;
}

std::vector<Stroke> clip(const Stroke& points, const Box& box) {
  std::vector<Stroke> pieces;
  bool joined = false;  // the last piece ends in points[i]
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    Point p = points[i], q = points[i + 1];
    if (!clip_segment(p, q, box)) {
      joined = false;
      continue;
    }
    if (!joined) pieces.push_back({p});
    pieces.back().push_back(q);
    joined = same(q, points[i + 1]);
  }
  return pieces;
}

}  // namespace pmreport::figure
