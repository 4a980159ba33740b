// Pictures made smaller.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

namespace pmreport::document {

struct DestroySurface {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
};
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

// The picture of a PNG at most `width` pixels wide, opaque on white; null when the bytes are no PNG.
Surface decoded(const std::string& png, int width);

// For a page: a PNG at most `width` pixels wide, on white, of at most 256 colours; itself where it is no PNG.
std::string narrowed(const std::string& png, int width);

}  // namespace pmreport::document
