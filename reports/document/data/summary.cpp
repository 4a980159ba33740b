// The first page for machines that build: summary.md, and lines that GitHub shows beside the scenario.
//
// A step summary of GitHub ends at 1 MiB and shows ten errors of a step; GitLab shows the same Markdown in a merge request's note. So
// lists and texts are cut, and what was cut is counted.
#include <reports/document/tally.hpp>
#include <reports/document/text.hpp>
#include <reports/document/write.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace pmreport::document {

namespace {

constexpr std::size_t most_listed = 20, most_annotations = 10;
constexpr std::size_t longest = 400;  // bytes of a text

// No longer than may be, and whole characters.
std::string cut(std::string text) {
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "…";
}

// Plain text as Markdown, of one line: nothing of it is markup, and it may stand in a table.
std::string plain(const std::string& text) {
  std::string out;
  for (const char c : cut(clean(text))) {
    if (c == '\n' || c == '\r' || c == '\t')
      out += ' ';
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      continue;
    else if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (std::string_view("\\`*_{}[]()#+-.!|~:@").find(c) != std::string_view::npos)
      out += std::string("\\") + c;
    else
      out += c;
  }
  return out;
}

std::string states(const Tally& t, const char* none) {
  if (t.total() == 0) return none;
  return counted(t,
                 {Verdict::passed, Verdict::failed, Verdict::error, Verdict::not_decided, Verdict::not_examined, Verdict::not_applicable});
}

std::string left_out(std::size_t all) { return all > most_listed ? fmt::format("\n{} more in the report\\.\n", all - most_listed) : ""; }

// Of a workflow command: what would end it, and in a property what would end that.
std::string escaped(const std::string& text, bool property) {
  std::string out;
  for (const char c : cut(clean(text))) {
    if (c == '%' || c == '\n' || c == '\r' || (property && (c == ':' || c == ',')))
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else if (static_cast<unsigned char>(c) >= 0x20)
      out += c;
  }
  return out;
}

}  // namespace

std::string to_markdown(const Report& r) {
  std::string out = fmt::format("## {} {}\n\n", r.passed() ? "✓" : "✗", r.title.empty() ? "Untitled report" : plain(r.title));
  if (!r.mechanism_title.empty()) out += plain(r.mechanism_title) + "\n\n";
  out += fmt::format("**{}**: checks: {}; evidence: {}\n", r.passed() ? "Passed" : "Failed", states(tally_checks(r), "none"),
                     states(tally_evidence(r), "none"));
  if (const std::vector<Failure> all = failures_of(r); !all.empty()) {
    out += "\n| what fails | found | limit |\n|---|---:|---:|\n";
    for (std::size_t i = 0; i < std::min(all.size(), most_listed); ++i)
      out += fmt::format("| **{}**{} | {} | {} |\n", plain(all[i].name), all[i].message.empty() ? "" : "<br>" + plain(all[i].message),
                         plain(all[i].worst), plain(all[i].limit));
    out += left_out(all.size());
  }
  if (!r.key_numbers.empty()) {
    out += "\n| key number | | used | limit | where |\n|---|---:|---:|---|---|\n";
    for (const KeyNumber& k : r.key_numbers)
      out += fmt::format("| {} | **{}** | {} | {} | {} |\n", plain(k.what), plain(k.value),
                         k.limited() ? fmt::format("{:.0f} %", 100 * k.used) : "", plain(k.limit), plain(k.where));
  }
  if (!r.findings.empty()) out += "\n";
  for (std::size_t i = 0; i < std::min(r.findings.size(), most_listed); ++i)
    out += fmt::format("* {}{}\n", r.findings[i].kind == Finding::Kind::fault ? "⚠ " : "", plain(r.findings[i].text));
  out += left_out(r.findings.size());
  if (const std::vector<std::string> told = unexamined(r); !told.empty()) {
    out += "\nNot examined:\n\n";
    for (const std::string& s : told) out += "* " + plain(s) + "\n";
  }
  return out;
}

std::string to_annotations(const Report& r, const std::string& file) {
  const std::vector<Failure> all = failures_of(r);
  std::string out;
  for (std::size_t i = 0; i < std::min(all.size(), most_annotations); ++i) {
    int line = 0;
    for (const Check& c : r.checks)
      if (all[i].section.empty() && !c.passed && c.name == all[i].name) line = c.line;
    const bool more = i + 1 == most_annotations && all.size() > most_annotations;
    out += fmt::format("::error file={}{},title={}::{}{}\n", escaped(file, true), line > 0 ? fmt::format(",line={}", line) : "",
                       escaped(all[i].name, true), escaped(all[i].message.empty() ? "found " + all[i].worst : all[i].message, false),
                       more ? fmt::format(" ({} more fail)", all.size() - most_annotations) : "");
  }
  return out;
}

}  // namespace pmreport::document
