// The legend of a panel: its keys, its shape, and a place where it covers no curve.
#pragma once

#include <cairo.h>

#include <string>
#include <vector>

#include <reports/figure/figure.hpp>
#include <reports/figure/layout/occupancy.hpp>

namespace pmreport::figure {

struct Key {
  // over_map: a curve that lies over a map; points: dots, points_over_map likewise
  enum class Kind { curve, limit, unreachable, over_map, contour, named, fill, points, points_over_map } kind;
  std::string label;
  int style = 0;    // of a curve; the dash of a named line; the class of a fill
  int series = -1;  // of the panel, where it is the key of one
};

struct Legend {
  struct Column {
    std::vector<Key> keys;  // top to bottom
    double width = 0;       // [pt] swatch and label
  };
  std::vector<Column> columns;
  int rows = 0;           // of the longest column
  double row_height = 0;  // [pt]
  Box box;                // [pt] panel coordinates
};

int style_of(const Series& series, std::size_t position);

// One key a labelled curve, one a kind of band, one a class that occurs on a map. Named lines have one only where their names find no room
// elsewhere, which the panel's layout knows.
std::vector<Key> keys_of(const Panel& panel);

// The legend in one, two, three... columns, as far as each fits `width` [pt]; a single column always does. Sized, not placed.
std::vector<Legend> legend_shapes(cairo_t* cr, const std::vector<Key>& keys, double width);

// Ink that a legend must not touch, and shading that it had better not.
struct Ground {
  Occupancy ink, shading;
};

// Puts the best shape where it touches no ink. Returns false when there is no such place.
bool place_inside(const std::vector<Legend>& shapes, const Ground& ground, double width, double height, Legend& placed);

// At its box, in panel coordinates; boxed: on white ground with a hairline around it, for a place inside the frame.
void draw_legend(cairo_t* cr, const Legend& legend, bool boxed);

}  // namespace pmreport::figure
