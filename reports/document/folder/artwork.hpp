// Everything of a report that takes time to draw.
#pragma once

#include <reports/document/names.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document {

struct Artwork {  // figures in the order of the report
  std::vector<std::string> svg, pdf;
  std::vector<std::string> picture_pdf;  // of pictures in the order of the report; empty where there is none
  std::string report_pdf;
};

// Draws on all processors; the result does not depend on how many there are. Throws Interrupted, and what a drawing throws.
Artwork draw_all(const Report& r, const Names& names, bool (*interrupted)());

// The SVG of each figure, with ids that stay apart when several stand in one page.
std::vector<std::string> draw_svg(const Report& r, const Names& names);

}  // namespace pmreport::document
