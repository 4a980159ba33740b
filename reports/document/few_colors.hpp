// A picture in a few colours, chosen for it: a third of its bytes, and hardly a difference to the eye.
#pragma once

#include <cairo.h>

#include <string>

namespace pmreport::document {

// A PNG of at most 256 colours: the picture's own where it has no more, and white stays white. `picture`: an image surface in
// CAIRO_FORMAT_RGB24. The same bytes every time. Empty where there is no picture, or not the memory.
std::string png_of_few_colors(cairo_surface_t* picture);

}  // namespace pmreport::document
