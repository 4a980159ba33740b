// Owning handles of Cairo, and surfaces that write into memory.
#pragma once

#include <cairo.h>

#include <functional>
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

// A page with what `draw` draws, the same bytes every time. `what` names it should Cairo fail; `named` gives the ids and the title of the
// SVG.
std::string written_pdf(const Size& size, const std::function<void(cairo_t*)>& draw, const std::string& what);
std::string written_svg(const Size& size, const std::function<void(cairo_t*)>& draw, const Figure& named);

}  // namespace pmreport::figure
