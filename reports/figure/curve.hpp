// From samples to strokes of the pen: gaps lifted, spikes cut at the frame, points that nobody could see left out.
#pragma once

#include <cstddef>
#include <vector>

#include <reports/figure/geometry.hpp>
#include <reports/figure/layout/axis.hpp>

namespace pmreport::figure {

using Stroke = std::vector<Point>;  // at least two points

// Where a curve leaves the frame: the mark drawn there.
struct Exit {
  double x;  // [pt] of the farthest sample
  bool above;
};

// Everything in panel coordinates [pt]: origin at the top left corner of the frame, all points inside it.
struct Trace {
  std::vector<Stroke> strokes;
  std::vector<Point> dots;  // samples alone between two gaps; of a series of points all that lie inside
  std::vector<Exit> exits;
};

struct Frame {
  double width, height;  // [pt]
  Interval x, y;         // [data units]
};

// A point of the data on the page. Values far outside the frame stay far outside, yet finite: Cairo wraps large coordinates silently.
Point to_page(const Frame& frame, double x, double y);

Trace trace(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame);
Trace trace_of_points(const std::vector<double>& x, const std::vector<double>& y, const Frame& frame);

// Of each run of points in one column, its first, lowest, highest and last, in their order: the ink stays the same. [pt]
Stroke decimate(const Stroke& points, double column);

// Of a curve of very many samples those that a drawing of it may need: decimated in columns narrower than those of any page, one missing
// sample for each gap. x has no NaN. Of fewer than `few_samples` all are kept.
constexpr std::size_t few_samples = 16384;
void thin_out(std::vector<double>& x, std::vector<double>& y);

// Ramer, Douglas and Peucker: the fewest of these points whose polyline passes every other one within `tolerance` [pt].
Stroke simplify(const Stroke& points, double tolerance);

// The parts of a polyline inside the box.
std::vector<Stroke> clip(const Stroke& points, const Box& box);

}  // namespace pmreport::figure
