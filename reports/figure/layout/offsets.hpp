// Curves far apart that each move little: drawn from an offset each, so that all of them can be seen to move.
#pragma once

#include <reports/figure/figure.hpp>

namespace pmreport::figure {

constexpr double flat_share = 0.04;  // of the height of a panel: a curve that is no higher tells nothing
constexpr double low_share = 0.25;   // a curve that is no higher tells little, where it matters not how far from zero it is

// A position of x, y around 0 and z around 66 mm that all move by some µm is three flat lines on one axis. Where no curve of a panel would
// be higher than this share of it, each is drawn less a round number near its middle, which its label tells: "z − 66 mm". Limits beyond the
// axis are told beside the heading. Not where a line in sight or a map shares the axis, or another axis its scale, where a curve has no
// label to say so, or where its style is given: such curves are held against those of other panels, or against each other, as shares are
// against their sum.
Panel set_off(const Panel& panel, double share = flat_share);
Figure set_off(const Figure& figure);  // every panel whose curves are flat

}  // namespace pmreport::figure
