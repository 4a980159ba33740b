// Tables as printers set them: three rules, no verticals, figures ranged right, the heading repeated on every page.
#pragma once

#include <reports/document/pdf/pdf_blocks.hpp>

#include <string>
#include <vector>

namespace pmreport::document::pdf {

struct Grid {
  std::string caption;                         // plain; empty without a number: none
  int number = 0;                              // "Table 2."; 0: none, the caption is a heading
  std::vector<std::string> headings;           // markup, as the cells are
  std::vector<bool> numeric;                   // as many as headings
  std::vector<std::vector<std::string>> rows;  // each as long as headings
  int stretch = -1;                            // column that takes what width is left, so that the table spans the text; -1: none
};

void put_grid(Composer& c, const Grid& g);

// Widths of columns and the size of type at which a table fits `available`. `natural` and `tight` are widths at `size` of every column on
// one line, and wrapped no further than between words; numeric columns wrap in their heading alone. Type shrinks down to `smallest` before
// words break.
struct Fit {
  double size;                // of type [pt]
  std::vector<double> width;  // [pt]
};
Fit fit_columns(const std::vector<double>& natural, const std::vector<double>& tight, double available, double size, double smallest);

}  // namespace pmreport::document::pdf
