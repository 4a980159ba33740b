// The report as PDF: composed into pages first, then drawn, so that the contents know their pages.
#include <reports/document/pdf/pdf_compose.hpp>
#include <reports/document/pdf/pdf_date.hpp>
#include <reports/document/pdf/pdf_finish.hpp>
#include <reports/document/write.hpp>

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <memory>
#include <new>
#include <optional>

namespace pmreport::document {

namespace pdf {
namespace {

struct Finish {
  void operator()(cairo_surface_t* s) const { cairo_surface_destroy(s); }
  void operator()(cairo_t* c) const { cairo_destroy(c); }
};

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  try {
    static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (const std::bad_alloc&) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

void demand(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw OutputError(fmt::format("report.pdf could not be drawn: Cairo says \"{}\"", cairo_status_to_string(status)));
}

void show_ranged(cairo_t* cr, const std::string& text, double y, double width, bool right) {
  const figure::Text set(cr, markup_line(text), secondary.font, 0, true);
  if (set.extents().width > width) {
    pango_layout_set_width(set.layout(), static_cast<int>(width * PANGO_SCALE));
    pango_layout_set_ellipsize(set.layout(), PANGO_ELLIPSIZE_END);
  }
  set_colour(cr, grey);
  set.show(right ? text_left + text_width - set.extents().width : text_left, y);
}

// Pieces of one element that follow each other on a page, such as the lines of a paragraph, are marked together.
void draw_page(Composer& c, const Page& page, std::size_t number, std::size_t pages) {
  cairo_t* const cr = c.cr;
  if (number > 1) {
    constexpr double y = 13 * mm;
    show_ranged(cr, c.report.title, y, 0.6 * text_width, false);
    show_ranged(cr, page.section, y, 0.38 * text_width, true);
    rule(cr, text_left, y + 14, text_width, 0.4, hairline);
  }
  show_ranged(cr, fmt::format("{} / {}", number, pages), paper_height - 14 * mm, text_width, true);
  std::optional<Mark> mark;
  int marked = -1;
  for (const auto& [y, piece, scale] : page.pieces) {
    if (piece.element != marked || !piece.destination.empty()) mark.reset();
    cairo_save(cr);
    cairo_translate(cr, text_left, y);
    if (!piece.destination.empty()) set_destination(cr, piece.destination);
    if (piece.element >= 0 && !mark) mark.emplace(cr, c.structure, piece.element);
    marked = piece.element;
    if (piece.draw) piece.draw(cr);
    if (piece.draw_scaled) piece.draw_scaled(cr, scale);
    cairo_restore(cr);
  }
}

void draw(Composer& c, cairo_surface_t* surface, const Plan& plan) {
  const std::vector<Page>& pages = c.flow.finish();
  const Tag document(c.cr, "Document");
  for (std::size_t i = 0; i < pages.size(); ++i) {
    cairo_pdf_surface_set_page_label(surface, fmt::to_string(i + 1).c_str());
    draw_page(c, pages[i], i + 1, pages.size());
    cairo_show_page(c.cr);
    demand(cairo_status(c.cr));
  }
  for (const auto& e : plan.all()) {
    c.flow.require(e.destination);
    cairo_pdf_surface_add_outline(surface, CAIRO_PDF_OUTLINE_ROOT, title_of(e).c_str(), fmt::format("dest='{}'", e.destination).c_str(),
                                  cairo_pdf_outline_flags_t{});
  }
}

std::string document_title(const Report& r) { return r.title.empty() ? "Untitled report" : printable_line(r.title); }
std::string creator_of(const Report& r) { return printable_line(r.provenance.program + " " + r.provenance.version); }

void describe(cairo_surface_t* surface, const Report& r) {
  const auto set = [&](cairo_pdf_metadata_t what, const std::string& text) {
    if (!text.empty()) cairo_pdf_surface_set_metadata(surface, what, printable_line(text).c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, document_title(r));
  set(CAIRO_PDF_METADATA_AUTHOR, r.author);
  set(CAIRO_PDF_METADATA_SUBJECT, r.mechanism_title);
  set(CAIRO_PDF_METADATA_CREATOR, creator_of(r));
}

}  // namespace
}  // namespace pdf

std::string to_pdf(const Report& r) {
  std::string bytes;
  const std::unique_ptr<cairo_surface_t, pdf::Finish> surface(
      cairo_pdf_surface_create_for_stream(pdf::append, &bytes, pdf::paper_width, pdf::paper_height));
  const std::unique_ptr<cairo_t, pdf::Finish> cr(cairo_create(surface.get()));
  pdf::describe(surface.get(), r);
  pdf::demand(cairo_status(cr.get()));
  pdf::Composer composer{.report = r, .names = names_of(r), .numbering = numbering_of(r), .cr = cr.get()};
  pdf::Attachments attached = pdf::attachments_of(r, composer.names);
  const pdf::Plan plan = pdf::plan_of(composer);
  pdf::compose(composer, plan, attached);
  pdf::draw(composer, surface.get(), plan);
  cairo_surface_finish(surface.get());
  pdf::demand(cairo_surface_status(surface.get()));
  return pdf::finished(bytes, {.structure = composer.structure,
                               .title = pdf::document_title(r),
                               .author = pdf::printable_line(r.author),
                               .creator = pdf::creator_of(r),
                               .attachments = std::move(attached.files),
                               .epoch = pdf::source_date_epoch()});
}

}  // namespace pmreport::document
