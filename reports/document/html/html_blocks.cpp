// Paragraphs, tables, figures, galleries and proofs of report.html.
#include <fmt/format.h>

#include <reports/document/finding.hpp>
#include <reports/document/html/figure_words.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/document/html/series_data.hpp>
#include <reports/document/narrowed.hpp>

namespace pmreport::document {

namespace {

// Where there is no word there is no heading, but an empty cell.
void write_heading(Page& page, const char* scope, const char* side, const std::string& text) {
  if (text.empty())
    page.html.element("td", {{"class", side}}, "");
  else
    page.html.element("th", {{"scope", scope}, {"class", side}}, text);
}

// "Table 3. caption", the number as the PDF has it; without one the caption alone.
void write_caption(Page& page, const char* kind, int number, const std::string& caption) {
  if (number > 0) page.html.element("strong", fmt::format("{} {}.", kind, number));
  if (!caption.empty()) page.html.text((number > 0 ? " " : "") + caption);
}

void write_table(Page& page, const Table& table, int number) {
  HtmlWriter& html = page.html;
  const auto side = [&](std::size_t column) { return column < table.numeric.size() && table.numeric[column] ? "number" : "words"; };
  write_scroll_box(page, table.caption, [&] {
    html.element("table", [&] {
      if (number > 0 || !table.caption.empty()) html.element("caption", [&] { write_caption(page, "Table", number, table.caption); });
      html.element("thead", [&] {
        html.element("tr", [&] {
          for (std::size_t c = 0; c < table.headings.size(); ++c) {
            write_heading(page, "col", side(c), table.headings[c]);
          }
        });
      });
      html.element("tbody", [&] {
        for (const auto& row : table.rows) {
          html.element("tr", [&] {
            for (std::size_t c = 0; c < row.size(); ++c) {
              if (c == 0) {
                write_heading(page, "row", side(c), row[c]);
              } else {
                // A list of numbers may break after its commas, so that it does not push the columns after it off a narrow screen.
                const bool list = side(c) == std::string_view("number") && row[c].find(", ") != std::string::npos;
                html.element("td", {{"class", list ? "number list" : side(c)}}, row[c]);
              }
            }
          });
        }
      });
    });
  });
}

void write_words(Page& page, const figure::Figure& figure) {
  HtmlWriter& html = page.html;
  html.element("details", {{"class", "words-of-figure"}}, [&] {
    html.element("summary", "What it shows, in words");
    for (const PanelWords& panel : words_of(figure)) {
      html.element("p", panel.heading);
      if (panel.lines.empty()) continue;
      html.element("ul", [&] {
        for (const std::string& line : panel.lines) html.element("li", line);
      });
    }
  });
}

void write_figure(Page& page, const figure::Figure& figure, int number) {
  HtmlWriter& html = page.html;
  const std::string& name = page.names.figures[page.figure];
  const std::string data = data_file(page.report, page.names, figure);
  const bool wide = figure.width == figure::Width::full;
  html.element("figure", {{"id", "figure-" + name}, {"class", wide ? "plot full" : "plot column"}}, [&] {
    write_scroll_box(page, figure.caption, [&] {
      html.element("div", {{"class", "drawing"}, {"role", "img"}, {"aria-label", name_of(figure)}},
                   [&] { html.markup(inline_svg(page.drawings[page.figure], page.glyphs)); });
    });
    if (const std::string series = series_data(figure); !series.empty())
      html.element("script", {{"type", "application/json"}}, [&] { html.markup(series); });
    html.element("figcaption", [&] {
      write_caption(page, "Figure", number, figure.caption + " ");
      html.element("span", {{"class", "files"}}, [&] {
        html.element("a", {{"href", "figures/" + name + ".pdf"}}, "PDF");
        html.text(" · ");
        html.element("a", {{"href", "figures/" + name + ".svg"}}, "SVG");
        if (data.empty()) return;
        html.text(" · ");
        html.element("a", {{"href", data}}, "data (CSV)");
      });
      write_words(page, figure);
    });
  });
  ++page.figure;
}

// As wide as they are shown on a screen of two pixels a point; the file beside the report has all.
constexpr int alone = 1000, beside_others = 860;  // [px]

void write_gallery(Page& page, const Gallery& gallery, int number) {
  if (gallery.pictures.empty()) return;
  HtmlWriter& html = page.html;
  const bool single = gallery.pictures.size() == 1, has_caption = !single || !gallery.caption.empty();
  html.element("figure", {{"class", single ? "gallery single" : "gallery"}}, [&] {
    html.element("div", {{"class", "pictures"}}, [&] {
      for (std::size_t i = 0; i < gallery.pictures.size(); ++i)
        write_picture(page, gallery.pictures[i], single ? alone : beside_others,
                      !single       ? letter_of(i)
                      : has_caption ? ""
                                    : fmt::format("Figure {}.", number));
    });
    if (has_caption) html.element("figcaption", [&] { write_caption(page, "Figure", number, gallery.caption); });
  });
}

// The result comes first: on a narrow screen it is what must not be scrolled out of sight.
void write_proof(Page& page, const Section& section, const Proof& proof) {
  HtmlWriter& html = page.html;
  write_scroll_box(page, "Evidence: " + section.title, [&] {
    html.element("table", {{"class", "proof"}}, [&] {
      html.element("caption", "Evidence");
      html.element("thead", [&] {
        html.element("tr", [&] {
          html.element("th", {{"scope", "col"}}, "Result");
          html.element("th", {{"scope", "col"}}, "Claim, and how it is shown");
          html.element("th", {{"scope", "col"}, {"class", "number"}}, "Value");
          html.element("th", {{"scope", "col"}, {"class", "number"}}, "Tolerance");
        });
      });
      html.element("tbody", [&] {
        for (const Evidence& line : proof.lines) {
          html.element("tr", [&] {
            html.element("td", [&] { write_result(page, line.verdict()); });
            html.element("th", {{"scope", "row"}}, [&] {
              html.element("div", line.claim);
              if (const std::string how = how_it_is_shown(line); !how.empty()) html.element("div", {{"class", "how"}}, how);
            });
            html.element("td", {{"class", "number"}}, number_shown(line, line.value));
            html.element("td", {{"class", "number"}}, number_shown(line, line.tolerance));
          });
        }
      });
    });
  });
}

}  // namespace

void write_picture(Page& page, const Picture& picture, int most_pixels, const std::string& label) {
  HtmlWriter& html = page.html;
  const std::string stem = "snapshots/" + page.names.pictures[page.picture];
  html.element("figure", [&] {
    if (picture.as_lines)
      html.element("div", {{"class", "lines"}, {"role", "img"}, {"aria-label", picture.caption}},
                   [&] { html.markup(inline_svg(picture.svg, page.glyphs)); });
    else
      html.open("img", {{"src", "data:image/png;base64," + base64(narrowed(picture.png, most_pixels))},
                        {"alt", picture.caption},
                        {"width", std::to_string(picture.width)},
                        {"height", std::to_string(picture.height)}});
    html.element("figcaption", [&] {
      if (!label.empty()) html.element("strong", label);
      html.text((label.empty() ? "" : " ") + picture.caption + " ");
      html.element("span", {{"class", "files"}}, [&] {
        if (page.names.drawn[page.picture]) {
          html.element("a", {{"href", stem + ".pdf"}}, "PDF");
          html.text(" · ");
          html.element("a", {{"href", stem + ".svg"}}, "SVG");
          html.text(" · ");
        }
        html.element("a", {{"href", stem + ".png"}}, "PNG");
      });
    });
  });
  ++page.picture;
}

void write_paragraph(Page& page, const Paragraph& paragraph) {
  switch (paragraph.tone) {
    case Paragraph::Tone::plain:
      page.html.element("p", paragraph.text);
      break;
    case Paragraph::Tone::note:
      page.html.element("p", {{"class", "note"}}, paragraph.text);
      break;
    case Paragraph::Tone::warning:
      page.html.element("p", {{"class", "warning"}}, [&] {
        page.html.element("strong", "⚠ Warning.");
        page.html.text(" " + paragraph.text);
      });
  }
}

void write_result(Page& page, Verdict verdict) {
  const auto say = [&](const char* style, const char* word) { page.html.element("span", {{"class", style}}, word); };
  switch (verdict) {
    case Verdict::passed:
      return say("result passed", "✓ passed");
    case Verdict::failed:
      return say("result failed", "✗ failed");
    case Verdict::not_decided:
      return say("result undecided", "? not decided");
    case Verdict::not_examined:
      return say("result", "– not examined");
    case Verdict::not_applicable:
      return say("result", "– not applicable");
    case Verdict::error:
      return say("result failed", "✗ error");
  }
}

void write_number(Page& page, const std::string& number) {
  if (number.empty()) return;
  page.html.element("span", {{"class", "section-number"}}, number);
  page.html.text(" ");
}

void write_block(Page& page, const Section& section, const Block& block, int number) {
  struct {
    Page& page;
    const Section& section;
    int number;
    void operator()(const Paragraph& paragraph) const { write_paragraph(page, paragraph); }
    void operator()(const Table& table) const { write_table(page, table, number); }
    void operator()(const figure::Figure& figure) const { write_figure(page, figure, number); }
    void operator()(const Gallery& gallery) const { write_gallery(page, gallery, number); }
    void operator()(const Proof& proof) const { write_proof(page, section, proof); }
  } const writer{page, section, number};
  std::visit(writer, block);
}

}  // namespace pmreport::document
