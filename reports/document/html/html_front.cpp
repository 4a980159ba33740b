// What stands before the sections: the machine, how it ended, key numbers, findings, what was not examined, what all rests on.
#include <fmt/format.h>

#include <reports/document/html/html_page.hpp>
#include <reports/document/tally.hpp>

#include <algorithm>

namespace pmreport::document {

namespace {

std::string plural(int count, const char* one, const char* many) { return std::to_string(count) + " " + (count == 1 ? one : many); }

// "10 checks: 10 passed", "46 lines of evidence: 45 passed, 1 not applicable"
void write_tally(HtmlWriter& html, const Tally& tally, const char* one, const char* many) {
  html.element("dt", tally.total() == 0 ? std::string("No ") + many : plural(tally.total(), one, many));
  html.element("dd", [&] {
    html.element("ul", {{"class", "states"}}, [&] {
      for (std::size_t i = 0; i < verdicts; ++i) {
        const auto v = static_cast<Verdict>(i);
        if (tally[v] == 0) continue;
        std::string word = word_of(v);
        std::ranges::replace(word, ' ', '-');
        html.element("li", {{"class", "state " + word}}, std::to_string(tally[v]) + " " + word_of(v));
      }
    });
  });
}

void write_verdict(Page& page) {
  HtmlWriter& html = page.html;
  const Report& r = page.report;
  const Tally checks = tally_checks(r), evidence = tally_evidence(r);
  const bool claims = checks.total() + evidence.total() > 0;
  html.element("div",
               {{"class", !claims      ? "verdict"
                          : r.passed() ? "verdict passed"
                                       : "verdict failed"}},
               [&] {
                 html.element("h2", !claims ? "Nothing to check" : r.passed() ? "✓ Passed" : "✗ Failed");
                 html.element("dl", [&] {
                   write_tally(html, checks, "check", "checks");
                   write_tally(html, evidence, "line of evidence", "lines of evidence");
                 });
                 for (const Finding& f : r.findings)
                   if (f.kind == Finding::Kind::disagreement) html.element("p", {{"class", "disagreement"}}, f.text);
               });
}

// The anchor of a section by its id; empty where there is none.
std::string anchor_of(const Page& page, const std::string& id) {
  for (std::size_t s = 0; s < page.report.sections.size(); ++s)
    if (page.report.sections[s].id == id) return page.names.sections[s];
  return "";
}

// The share of the limit as a bar that ends at one and a quarter, its limit at a tick. What it says stands beside it in words; drawn
// without a style attribute, which strict pages forbid.
void write_bar(HtmlWriter& html, double used) {
  html.markup(fmt::format(R"(<svg class="bar {}" viewBox="0 0 125 10" preserveAspectRatio="none" aria-hidden="true" focusable="false">)"
                          R"(<rect class="track" y="2" width="100" height="6"/><rect class="fill" y="2" width="{:.1f}" height="6"/>)"
                          R"(<rect class="tick" x="99.5" width="1" height="10"/></svg>)",
                          used > 1      ? "broken"
                          : used >= 0.8 ? "tight"
                                        : "well",
                          100 * std::clamp(used, 0.0, 1.25)));
}

void write_failures(Page& page) {
  const std::vector<Failure> all = failures_of(page.report);
  if (all.empty()) return;
  HtmlWriter& html = page.html;
  html.element("h3", {{"id", "failures"}}, "Failures");
  write_scroll_box(page, "Failures", [&] {
    html.element("table", {{"class", "proof"}}, [&] {
      html.element("thead", [&] {
        html.element("tr", [&] {
          html.element("th", {{"scope", "col"}}, "What fails");
          html.element("th", {{"scope", "col"}, {"class", "number"}}, "Found");
          html.element("th", {{"scope", "col"}, {"class", "number"}}, "Limit");
        });
      });
      html.element("tbody", [&] {
        for (const Failure& f : all)
          html.element("tr", [&] {
            html.element("th", {{"scope", "row"}}, [&] {
              const std::string anchor = f.section.empty() ? "checks" : anchor_of(page, f.section);
              html.element("div", [&] { html.element("a", {{"href", "#" + anchor}}, f.name); });
              if (!f.message.empty()) html.element("div", {{"class", "how"}}, f.message);
            });
            html.element("td", {{"class", "number"}}, f.worst);
            html.element("td", {{"class", "number"}}, f.limit);
          });
      });
    });
  });
}

void write_key_numbers(Page& page) {
  if (page.report.key_numbers.empty()) return;
  HtmlWriter& html = page.html;
  html.element("h3", "Key numbers");
  html.element("ul", {{"class", "keys"}}, [&] {
    for (const KeyNumber& k : page.report.key_numbers)
      html.element("li", [&] {
        const std::string anchor = anchor_of(page, k.section);
        html.element("div", {{"class", "what"}}, [&] {
          if (anchor.empty())
            html.text(k.what);
          else
            html.element("a", {{"href", "#" + anchor}}, k.what);
        });
        html.element("div", {{"class", "value"}}, k.value);
        if (k.limited()) write_bar(html, k.used);
        html.element("div", {{"class", "limit"}}, [&] {
          if (k.limited()) html.element("strong", fmt::format("{:.0f} %", 100 * k.used));
          html.text((k.limited() ? " · " : "") + k.limit);
        });
        if (!k.where.empty()) html.element("div", {{"class", "where"}}, k.where);
      });
  });
}

void write_findings(Page& page) {
  const auto told = [&](const Finding& f) { return told_by_a_failure(page.report, f); };
  if (std::ranges::all_of(page.report.findings, told)) return;
  HtmlWriter& html = page.html;
  html.element("h3", "Findings");
  html.element("ol", {{"class", "findings"}}, [&] {
    for (const Finding& f : page.report.findings) {
      if (told(f)) continue;
      html.element("li", {{"class", std::string("finding ") + name_of(f.kind) + "-found"}}, [&] {
        if (f.kind == Finding::Kind::fault) {
          html.element("strong", "⚠ Warning.");
          html.text(" ");
        }
        html.text(f.text + " ");
        if (const std::string anchor = anchor_of(page, f.section); !anchor.empty())
          for (std::size_t s = 0; s < page.report.sections.size(); ++s)
            if (page.report.sections[s].id == f.section) {
              html.element("a", {{"href", "#" + anchor}}, page.numbering.sections[s] + " " + page.report.sections[s].title);
              break;
            }
      });
    }
  });
}

void write_list(HtmlWriter& html, const char* heading, const char* kind, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  html.element("h3", heading);
  html.element(kind == std::string_view("assumptions") ? "ol" : "ul", {{"class", kind}}, [&] {
    for (const std::string& line : lines) html.element("li", line);
  });
}

}  // namespace

void write_front(Page& page) {
  HtmlWriter& html = page.html;
  const Report& r = page.report;
  html.element("section", {{"id", "summary"}, {"aria-label", "Summary"}}, [&] {
    html.element("div", {{"class", "front"}}, [&] {
      if (r.cover) write_picture(page, *r.cover, r.cover->width);
      write_verdict(page);
    });
    write_failures(page);
    write_key_numbers(page);
    write_findings(page);
    write_list(html, "Not examined", "unexamined", unexamined(r));
    if (!r.summary.empty()) html.element("h3", "What was asked");
    for (const Paragraph& paragraph : r.summary) write_paragraph(page, paragraph);
    write_list(html, "Assumptions", "assumptions", r.assumptions);
  });
}

}  // namespace pmreport::document
