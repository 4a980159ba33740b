#include <reports/figure/draw.hpp>

#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/offsets.hpp>
#include <reports/figure/surface.hpp>

namespace pmreport::figure {

Size size_of(const Figure& figure) { return lay_out(measuring_context().get(), set_off(figure)).size; }

void draw(cairo_t* cr, const Figure& figure) {
  const Figure as_drawn = set_off(figure);
  draw_layout(cr, as_drawn, lay_out(cr, as_drawn));
}

void draw_layout(cairo_t* cr, const Figure& figure, const Layout& layout) {
  cairo_save(cr);
  // The paper is drawn, so that the picture also reads where it is shown on a dark page.
  cairo_set_source_rgb(cr, 1, 1, 1);
  cairo_rectangle(cr, 0, 0, layout.size.width, layout.size.height);
  cairo_fill(cr);
  for (std::size_t i = 0; i < layout.panels.size(); ++i) draw_panel(cr, figure.panels[i], layout.panels[i]);
  cairo_restore(cr);
}

}  // namespace pmreport::figure
