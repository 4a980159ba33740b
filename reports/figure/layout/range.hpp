// Which part of the plane a panel shows.
#pragma once

#include <reports/figure/figure.hpp>
#include <reports/figure/layout/axis.hpp>

namespace pmreport::figure {

bool has_data(const Panel& panel);  // at least one finite point

// All finite x, without a margin: a motion fills its panel. Of a map, that of its grid.
Interval x_range(const Panel& panel);

// The finite y with a margin, near limit lines included, spikes cut off. `headroom` opens it above by that share, for a legend.
Interval y_range(const Panel& panel, double headroom = 0);

}  // namespace pmreport::figure
