// What of a panel's curves is to bear a name: curves that look like one stand together.
#pragma once

#include <cairo.h>

#include <vector>

#include <reports/figure/layout/direct_labels.hpp>
#include <reports/figure/palette.hpp>
#include <reports/figure/text.hpp>

namespace pmreport::figure {

// Curves that coincide throughout.
struct LabelGroup {
  std::vector<int> series;
  std::vector<double> widths;    // [pt] of their names
  double width = 0, height = 0;  // [pt] of these side by side
};
std::vector<LabelGroup> label_groups(cairo_t* cr, const Panel& panel, const std::vector<Trace>& traces, const Frame& frame);

// Where a group's names begin, and how high they are [pt].
struct LabelPlace {
  double left, top, height;
};
// The names of a group side by side; the leader is the first one's.
void add_labels(const Panel& panel, const LabelGroup& group, const LabelPlace& place, const Stroke& leader, bool inside, DirectLabels& out);

constexpr Font label_font{.size = tick_size};
constexpr double leader_gap = 0.8;  // [pt] from a leader to its name

}  // namespace pmreport::figure
