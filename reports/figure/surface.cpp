#include <reports/figure/draw.hpp>
#include <reports/figure/surface.hpp>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <stdexcept>
#include <string_view>

#include <reports/figure/embedding.hpp>
#include <reports/figure/layout/layout.hpp>
#include <reports/figure/layout/offsets.hpp>
#include <reports/figure/parts.hpp>

namespace pmreport::figure {
namespace {

cairo_status_t append(void* file, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void require_success(cairo_status_t status, const std::string& what) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(what + ": Cairo could not draw it: " + cairo_status_to_string(status));
}

void draw_and_finish(cairo_t* cr, cairo_surface_t* surface, const std::function<void(cairo_t*)>& draw, const std::string& what) {
  draw(cr);
  cairo_show_page(cr);
  require_success(cairo_status(cr), what);
  cairo_surface_finish(surface);
  require_success(cairo_surface_status(surface), what);
}

std::string name_of(const Figure& figure) { return "figure \"" + figure.id + "\""; }

// Cairo 1.16 writes the date that it is given without the "D:" which PDF 32000-1, 7.9.4 demands, and the current time when given none.
// A zone of +00:00 makes Cairo's text long enough that the right one replaces it in place; offsets in the file stay true.
constexpr const char* date_asked = "2000-01-01T00:00:00+00:00";
constexpr std::string_view date_written = "(20000101000000+00'00)";
constexpr std::string_view date_right = "(D:20000101000000Z)   ";
static_assert(date_written.size() == date_right.size());

void mend_date(std::string& pdf) {
  const auto at = pdf.find(date_written);
  if (at == std::string::npos)
    throw std::runtime_error("this version of Cairo writes PDF dates in another way: expected " + std::string(date_written));
  pdf.replace(at, date_written.size(), date_right);
}

}  // namespace

Context measuring_context() {
  const Surface surface{cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1)};
  return Context{cairo_create(surface.get())};
}

std::string written_pdf(const Size& size, const std::function<void(cairo_t*)>& draw, const std::string& what) {
  std::string pdf;
  const Surface surface{cairo_pdf_surface_create_for_stream(append, &pdf, size.width, size.height)};
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, date_asked);
  draw_and_finish(Context{cairo_create(surface.get())}.get(), surface.get(), draw, what);
  mend_date(pdf);
  return pdf;
}

std::string written_svg(const Size& size, const std::function<void(cairo_t*)>& draw, const Figure& named) {
  std::string svg;
  const Surface surface{cairo_svg_surface_create_for_stream(append, &svg, size.width, size.height)};
  cairo_svg_surface_set_document_unit(surface.get(), CAIRO_SVG_UNIT_PT);
  const Context cr{cairo_create(surface.get())};
  const Parts parts(cr.get());
  draw_and_finish(cr.get(), surface.get(), draw, name_of(named));
  return parts.put_into(embeddable_svg(svg, named));
}

std::string to_pdf(const Figure& figure) {
  const Figure as_drawn = set_off(figure);
  const Layout layout = lay_out(measuring_context().get(), as_drawn);
  return written_pdf(
      layout.size, [&](cairo_t* cr) { draw_layout(cr, as_drawn, layout); }, name_of(figure));
}

std::string to_svg(const Figure& figure) {
  const Figure as_drawn = set_off(figure);
  const Layout layout = lay_out(measuring_context().get(), as_drawn);
  return written_svg(
      layout.size, [&](cairo_t* cr) { draw_layout(cr, as_drawn, layout); }, figure);
}

}  // namespace pmreport::figure
