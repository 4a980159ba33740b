#include <reports/compare/drawing.hpp>
#include <reports/compare/page.hpp>
#include <reports/compare/words.hpp>

#include <reports/document/html/frame.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/figure/draw.hpp>

#include <fmt/format.h>

namespace pmreport::compare {

namespace {

using document::Page, document::HtmlWriter;

// Names of values are long words: on a narrow screen they break anywhere, and leave room for the numbers.
constexpr const char* narrow_style = R"css(
@media screen and (max-width: 60rem) { tbody th { overflow-wrap: anywhere; min-width: 8.5rem; } th, td { padding-right: .9rem; } }
)css";

struct Part {
  const char *anchor, *title;
  std::vector<document::Table> tables;
};

void write_tables(Page& page, const std::vector<document::Table>& tables) {
  for (const document::Table& table : tables) write_block(page, {}, table, 0);
}

void write_contents(HtmlWriter& html, const std::vector<Part>& parts, bool figures) {
  const auto item = [&](const char* anchor, const char* title) {
    html.element("li", [&] { html.element("a", {{"href", std::string("#") + anchor}}, title); });
  };
  html.element("nav", {{"id", "contents"}, {"aria-label", "Contents"}}, [&] {
    html.element("p", {{"class", "label"}}, "Contents");
    html.element("ol", [&] {
      item("summary", "Summary");
      for (const Part& part : parts)
        if (!part.tables.empty()) item(part.anchor, part.title);
      if (figures) item("curves", "Curves");
    });
  });
}

void write_figures(Page& page, const std::vector<figure::Figure>& figures) {
  HtmlWriter& html = page.html;
  html.element("div", {{"class", "pictures"}}, [&] {
    for (std::size_t i = 0; i < figures.size(); ++i) {
      html.element("figure", {{"id", "figure-" + figures[i].id}, {"class", "plot column"}}, [&] {
        document::write_scroll_box(page, figures[i].caption, [&] {
          html.element("div", {{"role", "img"}, {"aria-label", figures[i].caption}},
                       [&] { html.markup(document::inline_svg(figure::to_svg(figures[i]), page.glyphs)); });
        });
        html.element("figcaption", [&] {
          html.element("strong", fmt::format("Figure {}.", i + 1));
          html.text(" " + figures[i].caption);
        });
      });
    }
  });
}

void write_curves(Page& page, const Comparison& c, const std::vector<figure::Figure>& figures) {
  HtmlWriter& html = page.html;
  html.element("section", {{"id", "curves"}}, [&] {
    html.element("h2", "Curves");
    if (curves_to_draw(c) > figures.size())
      html.element(
          "p", {{"class", "note"}},
          fmt::format("Of {} curves that differ the {} that differ most for their size are drawn.", curves_to_draw(c), figures.size()));
    write_tables(page, curve_tables(c));
    write_figures(page, figures);
  });
}

void write_summary(Page& page, const Comparison& c) {
  HtmlWriter& html = page.html;
  html.element("section", {{"id", "summary"}, {"aria-label", "Summary"}}, [&] {
    html.element("div", {{"class", c.agree ? "verdict passed" : "verdict failed"}}, [&] {
      html.element("h2", c.agree ? "✓ They agree" : "✗ They differ");
      html.element("p", verdict(c));
    });
    for (const std::string& remark : remarks(c)) html.element("p", {{"class", "note"}}, remark);
    html.element("dl", [&] {
      for (std::size_t r = 0; r < c.reports.size(); ++r) {
        const Results& results = *c.reports[r];
        html.element("dt", letter(r));
        html.element("dd", [&] {
          html.element("strong", results.title);
          html.text(fmt::format(", {}: mechanism {}, scenario {}; {}", results.passed ? "passed" : "failed", results.mechanism,
                                results.scenario, results.label));
        });
      }
    });
  });
}

}  // namespace

std::string to_html(const Comparison& c, const std::string& version) {
  const std::vector<Part> parts{{"values", "Values", value_tables(c)},
                                {"verdicts", "Checks and evidence", judgement_tables(c)},
                                {"alone", "In one report only", lone_tables(c)}};
  const std::vector<figure::Figure> figures = figures_of(c);
  // The writer of tables is that of report.html, which asks for a report.
  const document::Report no_report;
  const document::Names no_names;
  const std::vector<std::string> no_drawings;
  Page page{no_report, no_names, no_drawings};
  HtmlWriter& html = page.html;
  const document::PageHead head{"Comparison of reports", "pmreport " + version, "What reports agree on, and where they differ"};
  write_frame(html, head, {document::html_style, document::html_theme, narrow_style}, [&] {
    write_contents(html, parts, !figures.empty());
    html.element("main", [&] {
      html.element("header", [&] { html.element("h1", "Comparison of reports"); });
      write_summary(page, c);
      for (const Part& part : parts) {
        if (part.tables.empty()) continue;
        html.element("section", {{"id", part.anchor}}, [&] {
          html.element("h2", part.title);
          write_tables(page, part.tables);
        });
      }
      if (!figures.empty()) write_curves(page, c, figures);
    });
  });
  return html.take();
}

}  // namespace pmreport::compare
