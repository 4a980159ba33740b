// Owning handles of Cairo, and surfaces that write into memory.
#pragma once

#include <cairo.h>

#include <memory>
#include <string>

#include <reports/figure/draw.hpp>

namespace pmreport::figure {

struct DestroyContext {
  void operator()(cairo_t* p) const { cairo_destroy(p); }
};
struct DestroySurface {
  void operator()(cairo_surface_t* p) const { cairo_surface_destroy(p); }
};
using Context = std::unique_ptr<cairo_t, DestroyContext>;
using Surface = std::unique_ptr<cairo_surface_t, DestroySurface>;

Context measuring_context();  // draws nowhere

}  // namespace pmreport::figure
