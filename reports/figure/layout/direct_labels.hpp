// The names of few curves on the curves themselves: at their right ends, or where they are apart.
#pragma once

#include <cairo.h>

#include <optional>
#include <string>
#include <vector>

#include <reports/figure/curve.hpp>
#include <reports/figure/figure.hpp>

namespace pmreport::figure {

struct DirectLabel {
  std::string text;
  int series = 0;  // of the panel
  int style = 0;
  Box box;              // [pt] panel coordinates
  Stroke leader = {};   // from the curve to the name; empty: the name stands at its curve
  bool inside = false;  // it stands inside the frame
};

struct DirectLabels {
  std::vector<DirectLabel> labels;
  double right = 0;  // [pt] from the frame to the end of the longest name outside it
};

constexpr std::size_t most_direct_labels = 6;

// Whether a panel's curves may bear their names: one to six named lines over plain ground.
bool may_label_directly(const Panel& panel);

// Names in a column right of the frame, each as high as its curve ends, moved apart where they would overlap, thin leaders to those that
// moved. Curves that coincide throughout share a row. None where curves end too close together to be told apart, or before the frame ends.
std::optional<DirectLabels> label_ends(cairo_t* cr, const Panel& panel, const std::vector<Trace>& traces, const Frame& frame);

// Names inside the frame, each nearer to its own curve than to any other, else at a short leader from it. `lines`: heights of limit lines,
// which no name may touch. None where a curve has no such place.
std::optional<DirectLabels> label_inside(cairo_t* cr, const Panel& panel, const std::vector<Trace>& traces,
                                         const std::vector<double>& lines, const Frame& frame);

// Each in its curve's colour, darkened until it reads as text.
void draw_direct_labels(cairo_t* cr, const DirectLabels& labels);

}  // namespace pmreport::figure
