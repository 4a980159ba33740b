// Cairo's SVG made fit to stand inside an HTML page beside others of its kind.
#pragma once

#include <string>

#include <reports/figure/draw.hpp>

namespace pmreport::figure {

// Without the XML declaration, with role and title, and with ids that begin with the figure's and count from 1: Cairo counts surfaces over
// the life of the process, so that its own ids would differ from run to run.
std::string embeddable_svg(const std::string& svg, const Figure& figure);

}  // namespace pmreport::figure
