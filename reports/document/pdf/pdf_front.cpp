#include <reports/document/pdf/pdf_front.hpp>
#include <reports/document/pdf/pdf_link.hpp>
#include <reports/document/tally.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::document::pdf {

namespace {

std::string kept(const Tally& t, const char* one, const char* many) {
  if (t.total() == 0) return fmt::format("no {}", many);
  const std::string others = counted(t, {Verdict::error, Verdict::not_decided, Verdict::not_examined, Verdict::not_applicable});
  return fmt::format("{} of {} {}{}", t[Verdict::passed], t.total(), t.total() == 1 ? one : many,
                     others.empty() ? "" : " (" + others + ")");
}

// A line that leads to where a claim failed.
void put_pointer(Composer& c, const std::string& what, const Entry& where) {
  const Lines lines(c.cr,
                    "See " + coloured("<b>" + markup_line(where.number) + "</b>", accent) + "  " +
                        coloured(markup_line(where.title), accent) + ": " + what,
                    body, text_width - 14);
  c.flow.put({.height = lines.height(), .draw = [lines, destination = where.destination, &flow = c.flow](cairo_t* cr) {
                flow.require(destination);
                const Link link(cr, destination, {14, 0, text_width - 14, lines.height()});
                set_colour(cr, bad);
                cairo_rectangle(cr, 0, -0.4, 4, lines.height() + 0.4);
                cairo_fill(cr);
                lines.draw(cr, 14, 0);
              }});
}

void put_verdict(Composer& c, const std::vector<Entry>& sections, const Entry& checks) {
  const Tally asked = tally_checks(c.report), shown = tally_evidence(c.report);
  const bool claims = asked.total() + shown.total() > 0, passed = c.report.passed();
  const Colour colour = !claims ? grey : passed ? good : bad;
  const Style large{{.size = 13, .bold = true}, 22};
  const Lines word(c.cr, coloured(!claims ? "NOTHING TO CHECK" : passed ? "PASSED" : "FAILED", colour), large, 0);
  const Lines counts(
      c.cr, kept(asked, "check", "checks") + " and " + kept(shown, "line of evidence", "lines of evidence") + (claims ? " hold" : ""), body,
      text_width - 14);
  const double height = large.pitch + counts.height() + 6;
  c.flow.gap(14);
  c.flow.put({.height = height,
              .draw =
                  [=](cairo_t* cr) {
                    set_colour(cr, colour);
                    cairo_rectangle(cr, 0, 0, 4, height);
                    cairo_fill(cr);
                    word.draw(cr, 14, 1);
                    counts.draw(cr, 14, large.pitch + 2);
                  },
              .keep_with_next = !passed});
  if (asked.failed() > 0) put_pointer(c, asked.failed() == 1 ? "a check fails" : fmt::format("{} checks fail", asked.failed()), checks);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (tally_evidence(c.report.sections[i]).failed() > 0) put_pointer(c, "evidence fails", sections[i]);
  }
}

}  // namespace

void put_title(Composer& c, const std::vector<Entry>& sections, const Entry& checks) {
  const Report& r = c.report;
  put_lines(c, r.title.empty() ? "Untitled report" : markup_line(r.title), title, 0, nullptr, true);
  c.flow.gap(4);
  if (!r.author.empty()) put_lines(c, markup_line(r.author), subheading, 0, nullptr, true);
  c.flow.gap(8);
  c.flow.put({.height = 2, .draw = [](cairo_t* cr) { rule(cr, 0, 1, text_width, 1.2, ink); }, .keep_with_next = true});
  c.flow.gap(10);
  c.flow.put({});
  put_field(c, "Mechanism", r.mechanism_title);
  put_field(c, "Source", r.source);
  put_field(c, "Scenario", r.provenance.scenario_name);
  if (!r.description.empty()) {
    c.flow.gap(10);
    put_lines(c, markup(r.description), body);
  }
  put_verdict(c, sections, checks);
  if (r.summary.empty()) return;
  put_subheading(c, "Summary");
  std::vector<Paragraph> summary = r.summary;
  std::stable_sort(summary.begin(), summary.end(), [](const Paragraph& a, const Paragraph& b) {
    return (a.tone == Paragraph::Tone::warning) > (b.tone == Paragraph::Tone::warning);
  });
  for (const auto& p : summary) put_paragraph(c, p);
}

void put_contents(Composer& c, const std::vector<Entry>& entries) {
  put_subheading(c, "Contents");
  const Style style{body.font, 16};
  for (std::size_t i = 0; i < entries.size(); ++i) {
    constexpr double number_width = 24, page_width = 22;  // [pt]
    const Entry& e = entries[i];
    auto text = std::make_shared<figure::Text>(c.cr, markup_line(e.title), style.font, 0, true);
    pango_layout_set_width(text->layout(), static_cast<int>((text_width - number_width - page_width - 20) * PANGO_SCALE));
    pango_layout_set_ellipsize(text->layout(), PANGO_ELLIPSIZE_END);
    const Lines number(c.cr, markup_line(e.number), style, 0);
    Piece piece{.height = style.pitch, .keep_with_next = i == 0};
    piece.draw = [=, destination = e.destination, &flow = c.flow](cairo_t* cr) {
      const std::string page_number = fmt::to_string(flow.page_of(destination));
      const Link link(cr, destination, {0, 0, text_width, style.pitch});
      const Lines page(cr, page_number, style, 0);
      number.draw(cr, 0, 0);
      set_colour(cr, ink);
      const auto extents = text->extents();
      const double baseline = style.pitch / 2 + 0.346 * style.font.size;
      text->show(number_width, baseline - extents.baseline);
      const double page_left = text_width - width_of(cr, page_number, style.font);
      page.draw(cr, page_left, 0);
      // Leaders are a dashed line of round dots: full stops would be read aloud and copied. They stand on one raster down the page.
      constexpr double pitch = 4.2;
      const double from = std::ceil((number_width + extents.width + 6) / pitch) * pitch, to = text_width - page_width;
      if (from >= to) return;
      const double dots[] = {0, pitch};
      cairo_save(cr);
      set_colour(cr, grey);
      cairo_set_line_width(cr, 0.8);
      cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
      cairo_set_dash(cr, dots, 2, 0);
      cairo_move_to(cr, from, baseline - 0.5);
      cairo_line_to(cr, to, baseline - 0.5);
      cairo_stroke(cr);
      cairo_restore(cr);
    };
    c.flow.put(std::move(piece));
  }
}

}  // namespace pmreport::document::pdf
