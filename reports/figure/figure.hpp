// A plot figure as data: panels of curves over a common kind of axis. Data come in display units (the caller has scaled them); NaN is a
// gap.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pmreport::figure {

struct Series {
  std::string label;         // plain text with Unicode, "l₁", "F₁"; empty: not in the legend
  std::vector<double> x, y;  // equally long; NaN or infinite y: gap
  int style = -1;            // index into palette and line styles; -1: position in the panel
  bool points = false;       // a dot at every sample, and no line
};

struct Axis {
  std::string label;  // "time", "limb length"
  std::string unit;   // "s", "mm", "°"; empty: a plain number
  // Of y: what stands at 0, 1, 2, ... from below, each on a row of its own, in the place of numbers; empty: numbers.
  std::vector<std::string> names = {};
};

struct Band {  // shaded interval of x: samples that break a limit, or cannot be reached
  double from, to;
  enum class Kind { limit, unreachable } kind;
};

struct Line {  // horizontal reference line: a limit
  double y;
  std::string label;  // "stroke ends", drawn small at its right end; may be empty
  // On which side of it nothing may be: hatched up to the frame. Where the line is off the scale, the panel says so.
  enum class Forbids { nothing, above, below } forbids = Forbids::nothing;
};

struct Mark {  // a point of a curve that counts, with its number beside it; at the edge of the frame where the curve leaves it there
  double x, y;
  std::string label;
  int style = 0;        // of its curve
  bool strong = false;  // bold: it counts most
};

// Values over a grid as colours. The panel's axes are those of the grid; its curves are drawn over the map, a style of 0 solid, others
// dashed. Diverging: symmetric about zero, with a bar beside the frame; sequential: from the least value to the most, likewise; classes: a
// value is the number of a class, from 0, each with a colour of its own and its name in the legend.
struct ColourMap {
  std::vector<double> x, y;    // of the columns and of the rows, evenly spaced and increasing, at least two
  std::vector<double> values;  // row by row; NaN: out of reach, grey and hatched
  Axis bar;                    // what the colours count
  std::string contour = {};    // "det G = 0": the contour of `level` in the legend; empty: no contour
  enum class Scale { diverging, sequential, classes } scale = Scale::diverging;
  std::vector<std::string> classes = {};
  std::string missing = "out of reach";  // what NaN means, in the legend
  double level = 0;                      // the value that the contour follows
};

// A line over a panel that carries its name on itself, such as a limit on a slice: x and y with gaps as of a series. Where no name finds
// room on its line or beside it, the line is dashed and the legend has the name.
struct NamedLine {
  std::string label;  // empty: it carries none
  std::vector<double> x, y;
};

struct Panel {
  std::string title;  // "limb lengths"; "(a)" and so on is added by the figure when it has several panels
  Axis x, y;
  std::vector<Series> series;
  std::vector<Band> bands;
  std::vector<Line> lines;
  std::optional<ColourMap> map = {};
  std::vector<NamedLine> named = {};
  bool equal = false;            // x and y to one scale, a drawing, not a diagram: the frame is as large as its data then need
  std::vector<Mark> marks = {};  // of small multiples
  std::string note = {};         // drawn small beside the heading: "limit 580 mm off the scale"
};

// Small multiples: panels row by row, the names of their rows at the left and of their columns on top. Panels of a column share one scale
// of y, all share that of x; the figure has no letters and no legend, for a row has one curve in each panel.
struct Multiples {
  std::vector<std::string> rows, columns;
};

enum class Width { column, full };  // 85 mm and 174 mm, the two widths of a journal

struct Figure {
  std::string id;       // file name without extension: "displacement"
  std::string caption;  // a sentence or two, for the report (not drawn)
  std::string data;     // "data/displacement.csv", the numbers behind it; may be empty
  Width width = Width::full;
  int columns = 2;  // panels side by side at full width
  std::vector<Panel> panels;
  std::optional<Multiples> multiples = {};
};

// What a panel is called in a figure that has several: a, b, ... z, aa.
std::string panel_letter(std::size_t panel);

}  // namespace pmreport::figure
