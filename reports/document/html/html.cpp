// The frame of report.html: head, title, contents, verdict, sections, checks, scenario, files, and the provenance as a colophon.
#include <fmt/format.h>
#include <reports/document/write.hpp>

#include <algorithm>
#include <reports/document/finding.hpp>
#include <reports/document/html/frame.hpp>
#include <reports/document/html/html_page.hpp>
#include <reports/document/html/html_view.hpp>
#include <reports/document/tally.hpp>
#include <reports/document/text.hpp>

namespace pmreport::document {

namespace {

void write_contents(Page& page) {
  HtmlWriter& html = page.html;
  const Report& r = page.report;
  const Numbering& n = page.numbering;
  const auto item = [&](const std::string& anchor, const std::string& number, const std::string& title, const Tally& tally) {
    html.element("li", [&] {
      html.element("a", {{"href", "#" + anchor}}, [&] {
        write_number(page, number);
        html.text(title);
      });
      if (tally.failed() > 0)
        html.element("span", {{"class", "failed"}, {"title", counted(tally, {Verdict::failed, Verdict::error})}}, " ✗");
    });
  };
  html.element("nav", {{"id", "contents"}, {"aria-label", "Contents"}}, [&] {
    html.element("p", {{"class", "label"}}, "Contents");
    html.element("ol", [&] {
      item("summary", "", "Summary", {});
      for (std::size_t s = 0; s < r.sections.size(); ++s)
        item(page.names.sections[s], n.sections[s], r.sections[s].title, tally_evidence(r.sections[s]));
      if (!r.checks.empty()) item("checks", n.checks, "Checks", tally_checks(r));
      item("scenario", n.scenario, "Scenario", {});
      if (!r.files.empty()) item("files", n.files, "Files", {});
      item("provenance", "", "Provenance", {});
    });
  });
}

void write_header(Page& page) {
  HtmlWriter& html = page.html;
  const Report& r = page.report;
  html.element("header", [&] {
    html.element("h1", r.title);
    if (!r.mechanism_title.empty()) html.element("p", {{"class", "mechanism"}}, r.mechanism_title);
    if (!r.author.empty()) html.element("p", {{"class", "author"}}, r.author);
    if (!r.description.empty()) html.element("p", {{"class", "description"}}, r.description);
    if (!r.source.empty()) html.element("p", {{"class", "source"}}, "Source of the mechanism: " + r.source);
    html.element("p", {{"class", "files"}}, [&] {
      html.text("Also as ");
      html.element("a", {{"href", "report.pdf"}}, "PDF");
      html.text(" · ");
      html.element("a", {{"href", "results.json"}}, "results (JSON)");
      html.text(" · ");
      html.element("a", {{"href", "junit.xml"}}, "JUnit");
    });
  });
}

void write_title(Page& page, const std::string& number, const std::string& title) {
  page.html.element("h2", [&] {
    write_number(page, number);
    page.html.text(title);
  });
}

void write_checks(Page& page) {
  HtmlWriter& html = page.html;
  if (page.report.checks.empty()) return;
  html.element("section", {{"id", "checks"}}, [&] {
    write_title(page, page.numbering.checks, "Checks");
    write_scroll_box(page, "Checks", [&] {
      html.element("table", {{"class", "proof"}}, [&] {
        html.element("caption", "What the scenario demands of the results");
        html.element("thead", [&] {
          html.element("tr", [&] {
            html.element("th", {{"scope", "col"}}, "Result");
            html.element("th", {{"scope", "col"}}, "Check");
            html.element("th", {{"scope", "col"}, {"class", "number"}}, "Measured");
            html.element("th", {{"scope", "col"}, {"class", "number"}}, "Limit");
          });
        });
        html.element("tbody", [&] {
          for (const Check& check : page.report.checks) {
            html.element("tr", [&] {
              html.element("td", [&] { write_result(page, check.passed ? Verdict::passed : Verdict::failed); });
              html.element("th", {{"scope", "row"}}, [&] {
                html.element("div", check.name);
                if (check.message.empty() && check.line <= 0) return;
                html.element("div", {{"class", "how"}}, [&] {
                  html.text(check.message);
                  if (check.line <= 0) return;
                  if (!check.message.empty()) html.text(" ");
                  html.element("a", {{"href", "#line-" + std::to_string(check.line)}}, "line " + std::to_string(check.line));
                });
              });
              html.element("td", {{"class", "number"}}, check.measured);
              html.element("td", {{"class", "number"}}, check.limit);
            });
          }
        });
      });
    });
  });
}

void write_files(Page& page) {
  HtmlWriter& html = page.html;
  const std::vector<File>& files = page.report.files;
  if (files.empty()) return;
  html.element("section", {{"id", "files"}}, [&] {
    write_title(page, page.numbering.files, "Files");
    write_scroll_box(page, "Files", [&] {
      html.element("table", [&] {
        html.element("caption", "To be used by other programs");
        html.element("thead", [&] {
          html.element("tr", [&] {
            html.element("th", {{"scope", "col"}}, "File");
            html.element("th", {{"scope", "col"}}, "What it holds");
            html.element("th", {{"scope", "col"}, {"class", "number"}}, "Size");
          });
        });
        html.element("tbody", [&] {
          for (std::size_t i = 0; i < files.size(); ++i) {
            const std::string name = "data/" + page.names.files[i];
            html.element("tr", [&] {
              html.element("th", {{"scope", "row"}}, [&] { html.element("a", {{"href", name}}, name); });
              html.element("td", files[i].title);
              html.element("td", {{"class", "number"}}, size_of(files[i].bytes.size()));
            });
          }
        });
      });
    });
  });
}

// Every line of the scenario is an anchor, so that a check can point at the line that asked for it.
void write_scenario(Page& page) {
  HtmlWriter& html = page.html;
  const std::string text = page.report.scenario_text;
  html.element("section", {{"id", "scenario"}}, [&] {
    write_title(page, page.numbering.scenario, "Scenario");
    html.element("details", [&] {
      html.element("summary", "The script that this report answers: " + page.report.provenance.scenario_name);
      html.element("pre", [&] {
        int number = 0;
        for (std::size_t at = 0; at < text.size();) {
          const std::size_t end = std::min(text.find('\n', at), text.size());
          html.element("span", {{"id", "line-" + std::to_string(++number)}, {"class", "line"}}, text.substr(at, end - at));
          html.markup("\n");
          at = end + 1;
        }
      });
    });
  });
}

void write_provenance(Page& page) {
  HtmlWriter& html = page.html;
  const Provenance& from = page.report.provenance;
  const auto item = [&](const char* term, const std::string& value) {
    if (value.empty()) return;
    html.element("dt", term);
    html.element("dd", value);
  };
  html.element("section", {{"id", "provenance"}}, [&] {
    html.element("h2", "Provenance");
    html.element("dl", [&] {
      item("Program", from.program + " " + from.version);
      item("Mechanism", from.mechanism);
      item("Plugin build", from.plugin_build);
      item("Scenario", from.scenario_name);
      item("SHA-256 of the scenario", from.scenario_sha256);
    });
  });
}

}  // namespace

std::string to_html(const Report& r, const Names& names, const std::vector<std::string>& drawings) {
  Page page{r, names, drawings};
  HtmlWriter& html = page.html;
  const PageHead head{r.title, r.provenance.program + " " + r.provenance.version,
                      r.description.empty() ? r.mechanism_title : r.description};
  write_frame(html, head, {html_style, html_theme, html_view_style}, [&] {
    write_contents(page);
    html.element("main", [&] {
      write_header(page);
      write_front(page);
      write_view(page);
      for (std::size_t s = 0; s < r.sections.size(); ++s) {
        const Section& section = r.sections[s];
        html.element("section", {{"id", names.sections[s]}}, [&] {
          write_title(page, page.numbering.sections[s], section.title);
          for (std::size_t b = 0; b < section.blocks.size(); ++b)
            write_block(page, section, section.blocks[b], page.numbering.blocks[s][b]);
        });
      }
      write_checks(page);
      write_scenario(page);
      write_files(page);
      write_provenance(page);
    });
    html.element("script", {{"type", "module"}}, [&] {
      html.markup("const liveModel = " + (r.live.empty() ? "null" : r.live) + ";\n");
      html.markup(html_script);
    });
  });
  return html.take();
}

}  // namespace pmreport::document
