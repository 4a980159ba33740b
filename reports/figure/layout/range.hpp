// Which part of the plane a panel shows.
#pragma once

#include <string>
#include <vector>

#include <reports/figure/figure.hpp>
#include <reports/figure/layout/axis.hpp>

namespace pmreport::figure {

bool has_data(const Panel& panel);  // at least one finite point

// All finite x, without a margin, for a motion fills its panel; with one for points, and where both axes have one scale. Of a map, that of
// its grid.
Interval x_range(const Panel& panel);

// The finite y with a margin, near limit lines included, spikes cut off. `headroom` opens it above by that share, for a legend.
Interval y_range(const Panel& panel, double headroom = 0);

// A frame of at most this size in which a step of x is as long as one of y: as large as can be, and where one side would be too short to
// read, more of the plane on that side.
struct EqualFrame {
  double width, height;  // [pt]
  Interval x, y;
};
EqualFrame fit_equal(Interval x, Interval y, double width, double height);
constexpr double least_equal_width = 110, least_equal_height = 64;  // [pt]

// "limits 760 to 1410 mm off the scale" of these limits, of two of a sign apart "limits ±600 N off the scale"; empty where there are none.
std::string limits_off_scale(std::vector<double> limits, const std::string& unit);

}  // namespace pmreport::figure
