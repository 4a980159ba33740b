#include <reports/program/cli/index_of_reports.hpp>

#include <core/text/text.hpp>
#include <reports/document/html/frame.hpp>
#include <reports/document/html/html_writer.hpp>
#include <reports/document/text.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace pmreport::program {

using document::HtmlWriter;

namespace {

constexpr const char* generator = "pmreport index";

// Colour says nothing that a word does not say too. A picture keeps its white paper in the dark.
constexpr const char* style = R"css(
:root { color-scheme: light dark; --ink: #1b1f24; --quiet: #565e68; --rule: #d5dae0; --paper: #fff; --link: #0b4f8a; --good: #17663a; --bad: #a3161c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e9ed; --quiet: #a9b2bd; --rule: #38414b; --paper: #13171c; --link: #86bff5; --good: #74d198; --bad: #ff928c; }
  img { filter: brightness(.88); } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 76rem; padding: 1.5rem 1.1rem 4rem; color: var(--ink); background: var(--paper); -webkit-text-size-adjust: 100%; text-size-adjust: 100%;
  font: 1rem/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "Liberation Sans", "DejaVu Sans", sans-serif; font-variant-numeric: tabular-nums; overflow-wrap: anywhere; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.1rem; line-height: 1.3; margin: 0 0 .2rem; }
p { margin: .25rem 0; }
a { color: var(--link); text-underline-offset: .15em; }
a:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.quiet { color: var(--quiet); font-size: .925rem; }
ul { list-style: none; margin: 1.5rem 0 0; padding: 0; display: grid; gap: 1.2rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 21rem), 1fr)); }
li { border: 1px solid var(--rule); border-top: .35rem solid var(--good); padding: 1rem 1.1rem; }
li.failed, li.error { border-top-color: var(--bad); }
img { display: block; width: 100%; height: auto; margin: 0 0 .8rem; background: #fff; border: 1px solid var(--rule); }
.verdict { font-weight: 650; color: var(--good); } .failed .verdict, .error .verdict { color: var(--bad); }
pre { margin: .6rem 0 0; white-space: pre-wrap; font: .85rem/1.45 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
@media print { li { break-inside: avoid; } }
)css";

// A name of a folder in a link.
std::string in_link(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

int count_of(const std::map<std::string, int>& tally, const char* verdict) {
  const auto found = tally.find(verdict);
  return found != tally.end() ? found->second : 0;
}

// "5 checks, 1 failed; 23 lines of evidence, 2 not examined"
std::string counts_of(const Outcome& o) {
  const auto words = [](const std::map<std::string, int>& tally, const char* one, const char* several) {
    const int total = count_of(tally, "total");
    std::string out = fmt::format("{} {}", total, total == 1 ? one : several);
    for (const auto& [verdict, word] : {std::pair{"failed", "failed"},
                                        {"error", "error"},
                                        {"not_decided", "not decided"},
                                        {"not_examined", "not examined"},
                                        {"not_applicable", "not applicable"}})
      if (const int n = count_of(tally, verdict); n > 0) out += fmt::format(", {} {}", n, word);
    return out;
  };
  return words(o.checks, "check", "checks") + "; " + words(o.evidence, "line of evidence", "lines of evidence");
}

std::string verdict_words(const Outcome& o) {
  switch (o.status) {
    case 0:
      return "Passed";
    case 1:
      return "Failed";
    case 2:
      return "No report: the scenario is wrong";
    case 3:
      return "No report: the mechanism's plugin failed";
    case 4:
      return "No report: it could not be written";
    case 5:
      return "No report: a limit of time or memory";
    case 130:
    case 143:
      return "No report: interrupted";
    default:
      return "No report: it was ended from outside";
  }
}

void write_card(HtmlWriter& html, const Outcome& o) {
  html.element("li", {{"class", o.verdict()}}, [&] {
    const std::string page = in_link(o.folder) + "/report.html";
    if (!o.thumbnail.empty())
      html.open("img", {{"src", "data:image/png;base64," + document::base64(o.thumbnail)}, {"alt", o.thumbnail_words}});
    html.element("h2", [&] {
      if (o.made())
        html.element("a", {{"href", page}}, o.title);
      else
        html.text(o.scenario);
    });
    if (o.made()) html.element("p", {{"class", "quiet"}}, o.mechanism_title.empty() ? o.mechanism : o.mechanism_title);
    html.element("p", {{"class", "verdict"}}, verdict_words(o));
    if (o.made())
      html.element("p", {{"class", "quiet"}}, counts_of(o) + "; from " + o.scenario);
    else
      html.element("pre", o.error);
  });
}

nlohmann::ordered_json outcome_as_json(const Outcome& o) {
  nlohmann::ordered_json out{{"scenario", document::clean(o.scenario)}, {"verdict", o.verdict()}, {"status", o.status}};
  if (o.made()) {
    out["folder"] = document::clean(o.folder);
    out["title"] = document::clean(o.title);
    out["mechanism"] = document::clean(o.mechanism);
    out["checks"] = o.checks;
    out["evidence"] = o.evidence;
  } else {
    out["error"] = document::clean(o.error);
  }
  return out;
}

}  // namespace

std::string tally_of(const std::vector<Outcome>& outcomes) {
  const auto count = [&](auto of) { return std::ranges::count_if(outcomes, of); };
  const auto passed = count([](const Outcome&o) { return o.status == 0; }), failed = count([](const Outcome&o) { return o.status == 1; });
  const auto none = count([](const Outcome& o) { return !o.made(); });
  std::string out = fmt::format("{} scenarios: {} passed", outcomes.size(), passed);
  if (failed > 0) out += fmt::format(", {} failed", failed);
  if (none > 0) out += fmt::format(", {} without a report", none);
  return out;
}

std::string index_html(const std::vector<Outcome>& outcomes) {
  std::vector<Outcome> ordered = outcomes;
  std::ranges::stable_partition(ordered, [](const Outcome& o) { return o.status != 0; });
  HtmlWriter html;
  const document::PageHead head{"Reports: " + tally_of(outcomes), generator, "Reports of several scenarios, those that did not pass first"};
  write_frame(html, head, {style}, [&] {
    html.element("main", [&] {
      html.element("h1", "Reports");
      html.element("p", tally_of(outcomes));
      std::vector<std::string> wrong;
      for (const Outcome& o : ordered)
        if (o.status != 0) wrong.push_back(o.made() ? o.title : o.scenario);
      if (!wrong.empty()) html.element("p", "Not passed: " + fmt::format("{}", fmt::join(wrong, "; ")));
      html.element("ul", [&] {
        for (const Outcome& o : ordered) write_card(html, o);
      });
    });
  });
  return html.take();
}

std::string index_json(const std::vector<Outcome>& outcomes) {
  int worst = 0;
  nlohmann::ordered_json reports = nlohmann::ordered_json::array();
  for (const Outcome& o : outcomes) {
    worst = std::max(worst, o.status);
    reports.push_back(outcome_as_json(o));
  }
  return nlohmann::ordered_json{{"schema", "pmreport-index"}, {"schema_version", 1}, {"status", worst}, {"reports", reports}}.dump(2) +
         "\n";
}

bool is_index(const std::string& html) { return html.find(fmt::format("content=\"{}\"", generator)) != std::string::npos; }

}  // namespace pmreport::program
