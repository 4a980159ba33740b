// Where values over a grid are zero, as lines.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include <reports/figure/curve.hpp>

namespace pmreport::figure {

// Of bilinear values, in the units of x and y: `values` row by row, x along a row. A cell with a value missing has no line. Values larger
// than `pole` change their sign at a pole, not at zero. Only pieces with a middle that is wanted are kept; those that go on from one
// another are one stroke, closed where it ends where it began.
std::vector<Stroke> zero_lines(
    const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& values,
    double pole = std::numeric_limits<double>::infinity(), const std::function<bool(Point)>& wanted = [](Point) { return true; });

}  // namespace pmreport::figure
