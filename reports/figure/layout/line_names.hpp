// Names on lines: where each stands so that it covers nothing else, and what is left of the lines beside it.
#pragma once

#include <cairo.h>

#include <string>
#include <vector>

#include <reports/figure/curve.hpp>
#include <reports/figure/figure.hpp>
#include <reports/figure/layout/occupancy.hpp>

namespace pmreport::figure {

// A box turned about its middle, as the text in it. Panel coordinates [pt].
struct LineName {
  std::string text;
  Point middle{};
  double angle = 0;  // [rad], clockwise on the page; within a right angle of level
  double width = 0, height = 0;

  bool covers(Point p, double margin = 0) const;
};

struct NamedStrokes {
  std::vector<Stroke> strokes;  // without the pieces that names stand on
  int dash = 0;                 // 0: solid, the name stands on the line or beside it; else it found no room, and the legend has it
};

struct NamedLines {
  std::vector<NamedStrokes> lines;  // one a line
  std::vector<LineName> names;
};

// Each name stands on its line where that is straight enough, as level and as near to the middle as can be; else beside it; every long
// stroke of a line bears it. `other`: more that no name may cover.
NamedLines lay_out_named(cairo_t* cr, const std::vector<NamedLine>& lines, const Frame& frame, const std::vector<Stroke>& other);

void mark(Occupancy& ink, const NamedLines& named);

// Dark, on a light casing that sets them off from any colour beneath.
void draw_named(cairo_t* cr, const NamedLines& named);
void draw_names(cairo_t* cr, const NamedLines& named);
std::vector<double> named_dash(int dash);

constexpr double named_width = 1.0;  // [pt]
constexpr double name_size = 6.5;

}  // namespace pmreport::figure
