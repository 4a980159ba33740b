// Where pages end: chosen for the whole document at once, as a paragraph's lines are by Knuth and Plass ("Breaking paragraphs into lines",
// Software: Practice and Experience 11, 1981).
#pragma once

#include <cstddef>
#include <vector>

namespace pmreport::document::pdf {

// What an end of page costs. The unit is arbitrary; what counts is which fault is preferred to which.
inline constexpr double never = 1e6;          // a heading at the foot, a single line, a table's head without rows
inline constexpr double split_small = 1600;   // a table of few rows in two
inline constexpr double parted = 1300;        // a section's heading and introduction, and its first figure or table
inline constexpr double mostly_white = 1000;  // a page that is white for more than a third, and the same again for each further third
inline constexpr double split_low = 250;      // a table of few rows that is higher than a third of a page
inline constexpr double split_large = 12;     // a table of many rows
inline constexpr double split_paragraph = 6;  // at any of its lines
inline constexpr double most_white = 0.32;    // a third of the text, less the air below a last line
inline constexpr double least_scale = 0.85;   // of figures and pictures
inline constexpr double most_stretch = 1.0;   // by which the white between the items of a page grows where it would else be mostly white

struct Item {
  double height;          // [pt]
  bool scales = false;    // down to least_scale
  double gap = 0;         // between the item before it and this [pt]
  double reluctance = 0;  // of a page to end after it, one of the costs above
  int block = 0;          // the block and the section that it belongs to, counted up
  int section = 0;
  bool may_move = false;   // its block
  bool stands_in = false;  // a table: it may follow an introduction in place of a figure
  double head = 0;         // height of what a page that begins with it repeats from a table [pt]
};

struct Sheet {
  std::vector<std::size_t> items;  // in the order in which they stand
  std::vector<double> y;           // of their tops, below what is repeated above them [pt]
  double scale = 1;                // of those that scale
  double stretch = 0;              // of the white between them, 0.1 for a tenth more
  double used = 0;                 // height that is taken [pt]
};

// Every item on a sheet `height` high, in order, but for blocks that moved behind those that follow them. An item higher than that has a
// sheet of its own. The total cost is the least there is; the white of the last sheet costs nothing. `weighed`, where it is given, gets how
// many ends of sheets were weighed against one another, which is what all this takes.
std::vector<Sheet> break_pages(const std::vector<Item>& items, double height, std::size_t* weighed = nullptr);

}  // namespace pmreport::document::pdf
