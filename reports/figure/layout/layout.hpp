// Where everything of a figure goes, before a line of it is drawn.
#pragma once

#include <cairo.h>

#include <optional>
#include <string>
#include <vector>

#include <reports/figure/colour_bar.hpp>
#include <reports/figure/colour_map.hpp>
#include <reports/figure/curve.hpp>
#include <reports/figure/draw.hpp>
#include <reports/figure/geometry.hpp>
#include <reports/figure/layout/axis.hpp>
#include <reports/figure/layout/direct_labels.hpp>
#include <reports/figure/layout/legend.hpp>
#include <reports/figure/layout/line_names.hpp>

namespace pmreport::figure {

inline constexpr double edge = 1.5;  // [pt] nothing touches the edge of the picture

struct LineLabel {
  std::string text;
  Box box;  // [pt] panel coordinates
};

// Panel coordinates have their origin at the top left corner of the frame.
struct PanelLayout {
  Box frame;  // [pt] on the page
  Frame window{};
  Scale x, y;
  bool empty = false;         // no finite data: a frame without numbers
  std::vector<Trace> traces;  // one a series
  std::vector<Box> limit_bands, unreachable_bands;
  std::vector<double> lines;  // [pt] heights of the limit lines inside the frame
  std::vector<LineLabel> line_labels;
  NamedLines named;
  ColourBar bar;                // of a map
  std::vector<Stroke> contour;  // of a map
  DirectLabels direct;          // none: the legend has the names of the curves
  enum class Place { none, inside, below } legend_place = Place::none;
  Legend legend;
  std::vector<Box> mark_labels;  // one a mark of the panel
  std::string heading;           // Pango markup
  std::string spike_note;        // what was cut off, and how far it goes
  double x_title_y = 0;          // [pt] panel coordinates, top of the title
  double y_title_x = 0;
  // Of small multiples: titles of axes and numbers of x stand once for all, and the row has a name.
  bool x_titled = true, y_titled = true, x_numbered = true;
  std::string row_name;
  double row_name_x = 0;  // [pt] panel coordinates
  int row_style = 0;
};

struct Layout {
  Size size{};
  std::vector<PanelLayout> panels;
};

// `cr` only measures text; the layout does not depend on its surface.
Layout lay_out(cairo_t* cr, const Figure& figure);

// One panel whose frame has this size [pt], or less where it is to one scale; its place on the page is left open. A legend below the frame
// may be as wide as `room` [pt]. `shared`: the range of y, where other panels have it too; then the curves have no names.
PanelLayout lay_out_panel(cairo_t* cr, const Panel& panel, double width, double height, double room,
                          std::optional<Interval> shared = std::nullopt);

// Of a figure of small multiples.
Layout lay_out_multiples(cairo_t* cr, const Figure& figure, double width);

// White paper and every panel.
void draw_layout(cairo_t* cr, const Figure& figure, const Layout& layout);
void draw_panel(cairo_t* cr, const Panel& panel, const PanelLayout& layout);

constexpr double tick_length = 2.5;  // [pt]
constexpr double tick_gap = 1.8;     // [pt] from a tick to its label
constexpr double title_gap = 2.5;    // [pt] from tick labels to the axis title
constexpr double heading_gap = 2.5;  // [pt] from the heading to the frame
constexpr double exit_mark = 4.2;    // [pt] size of the triangle where a curve leaves the frame
constexpr double note_distance = 6;  // [pt] from the heading to a note on its line

}  // namespace pmreport::figure
