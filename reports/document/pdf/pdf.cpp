// The report as PDF: composed into pages first, then drawn, so that the contents know their pages.
#include <reports/document/pdf/pdf_appendix.hpp>
#include <reports/document/pdf/pdf_date.hpp>
#include <reports/document/pdf/pdf_front.hpp>
#include <reports/document/pdf/pdf_link.hpp>
#include <reports/document/write.hpp>

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <memory>
#include <new>

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

struct Plan {
  std::vector<Entry> sections;
  Entry checks, scenario, provenance;
  std::vector<Entry> all() const {
    std::vector<Entry> result = sections;
    result.insert(result.end(), {checks, scenario, provenance});
    return result;
  }
};

Plan plan_of(const Report& r, const Names& names) {
  Plan plan;
  for (std::size_t i = 0; i < r.sections.size(); ++i) {
    const Section& s = r.sections[i];
    plan.sections.push_back({fmt::to_string(i + 1), s.title.empty() ? s.kind : s.title, names.sections[i]});
  }
  plan.checks = {fmt::to_string(r.sections.size() + 1), "Checks", "checks"};
  plan.scenario = {"A", "Scenario", "scenario"};
  plan.provenance = {"B", "Provenance", "provenance"};
  return plan;
}

struct PutBlock {
  Composer& c;
  void operator()(const Paragraph& p) const { put_paragraph(c, p); }
  void operator()(const Table& t) const { put_table(c, t); }
  void operator()(const figure::Figure& f) const { put_figure(c, f); }
  void operator()(const Gallery& g) const { put_gallery(c, g); }
  void operator()(const Proof& p) const { put_proof(c, p); }
};

void begin(Composer& c, const Entry& e) {
  c.flow.section(printable_line(e.number + "  " + e.title));
  put_heading(c, e.number, e.title, e.destination);
}

void compose(Composer& c, const Plan& plan) {
  const Report& r = c.report;
  put_title(c, plan.sections, plan.checks);
  put_contents(c, plan.all());
  for (std::size_t i = 0; i < r.sections.size(); ++i) {
    begin(c, plan.sections[i]);
    for (const auto& block : r.sections[i].blocks) std::visit(PutBlock{c}, block);
    if (r.sections[i].blocks.empty()) put_lines(c, "This section is empty.", secondary);
  }
  begin(c, plan.checks);
  put_checks(c, r.checks);
  begin(c, plan.scenario);
  put_listing(c, r.scenario_text);
  begin(c, plan.provenance);
  put_provenance(c, r.provenance);
  put_files(c);
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

void draw_page(const Composer& c, const Page& page, std::size_t number, std::size_t pages) {
  cairo_t* const cr = c.cr;
  if (number > 1) {
    constexpr double y = 13 * mm;
    show_ranged(cr, c.report.title, y, 0.6 * text_width, false);
    show_ranged(cr, page.section, y, 0.38 * text_width, true);
    rule(cr, text_left, y + 14, text_width, 0.4, hairline);
  }
  show_ranged(cr, fmt::format("{} / {}", number, pages), paper_height - 14 * mm, text_width, true);
  for (const auto& placed : page.pieces) {
    cairo_save(cr);
    cairo_translate(cr, text_left, placed.y);
    if (!placed.piece.destination.empty()) set_destination(cr, placed.piece.destination);
    if (placed.piece.draw) {
      const Tag tag(cr, placed.piece.role);
      placed.piece.draw(cr);
    }
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
    cairo_pdf_surface_add_outline(surface, CAIRO_PDF_OUTLINE_ROOT, printable_line(e.number + "  " + e.title).c_str(),
                                  fmt::format("dest='{}'", e.destination).c_str(), cairo_pdf_outline_flags_t{});
  }
}

void describe(cairo_surface_t* surface, const Report& r) {
  const auto set = [&](cairo_pdf_metadata_t what, const std::string& text) {
    if (!text.empty()) cairo_pdf_surface_set_metadata(surface, what, printable_line(text).c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, r.title);
  set(CAIRO_PDF_METADATA_AUTHOR, r.author);
  set(CAIRO_PDF_METADATA_SUBJECT, r.mechanism_title);
  set(CAIRO_PDF_METADATA_CREATOR, r.provenance.program + " " + r.provenance.version);
  set(CAIRO_PDF_METADATA_CREATE_DATE, placeholder_date);
}

}  // namespace
}  // namespace pdf

std::string to_pdf(const Report& r) {
  std::string bytes;
  {
    const std::unique_ptr<cairo_surface_t, pdf::Finish> surface(
        cairo_pdf_surface_create_for_stream(pdf::append, &bytes, pdf::paper_width, pdf::paper_height));
    pdf::describe(surface.get(), r);
    {
      const std::unique_ptr<cairo_t, pdf::Finish> cr(cairo_create(surface.get()));
      pdf::demand(cairo_status(cr.get()));
      pdf::Composer composer{.report = r, .names = names_of(r), .cr = cr.get()};
      const pdf::Plan plan = pdf::plan_of(r, composer.names);
      pdf::compose(composer, plan);
      pdf::draw(composer, surface.get(), plan);
    }
    cairo_surface_finish(surface.get());
    pdf::demand(cairo_surface_status(surface.get()));
  }
  pdf::settle_date(bytes, pdf::source_date_epoch());
  return bytes;
}

}  // namespace pmreport::document
