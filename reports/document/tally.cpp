#include <reports/document/tally.hpp>

#include <core/text/text.hpp>
#include <reports/document/finding.hpp>

#include <algorithm>
#include <numeric>

namespace pmreport::document {

Tally& Tally::operator+=(const Tally& other) {
  for (std::size_t i = 0; i < verdicts; ++i) counts[i] += other.counts[i];
  return *this;
}

int Tally::total() const { return std::accumulate(counts.begin(), counts.end(), 0); }

Tally tally_checks(const Report& r) {
  Tally tally;
  for (const Check& check : r.checks) ++tally[check.passed ? Verdict::passed : Verdict::failed];
  return tally;
}

Tally tally_evidence(const Section& s) {
  Tally tally;
  for (const Block& block : s.blocks)
    if (const auto* proof = std::get_if<Proof>(&block))
      for (const Evidence& line : proof->lines) ++tally[line.verdict()];
  return tally;
}

Tally tally_evidence(const Report& r) {
  Tally tally;
  for (const Section& section : r.sections) tally += tally_evidence(section);
  return tally;
}

bool Report::passed() const { return tally_checks(*this).failed() == 0 && tally_evidence(*this).failed() == 0; }

const char* name_of(Finding::Kind kind) {
  switch (kind) {
    case Finding::Kind::fault:
      return "fault";
    case Finding::Kind::disagreement:
      return "disagreement";
    case Finding::Kind::surprise:
      return "surprise";
    case Finding::Kind::result:
      break;
  }
  return "result";
}

std::string word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::passed:
      return "passed";
    case Verdict::failed:
      return "failed";
    case Verdict::not_decided:
      return "not decided";
    case Verdict::not_examined:
      return "not examined";
    case Verdict::not_applicable:
      return "not applicable";
    case Verdict::error:
      return "error";
  }
  return "";
}

std::string counted(const Tally& tally, std::initializer_list<Verdict> which) {
  std::string out;
  for (const Verdict v : which) {
    const int n = tally[v];
    if (n == 0) continue;
    out += (out.empty() ? "" : ", ") + std::to_string(n) + " " + word_of(v) + (v == Verdict::error && n > 1 ? "s" : "");
  }
  return out;
}

std::vector<std::string> unexamined(const Report& r) {
  constexpr std::size_t most = 5;
  // Claims of one section that share a reason share a line.
  struct Line {
    std::string section, why;
    std::vector<std::string> claims;
  };
  std::vector<Line> lines;
  for (const Section& s : r.sections)
    for (const Block& block : s.blocks)
      if (const auto* proof = std::get_if<Proof>(&block))
        for (const Evidence& e : proof->lines) {
          if (e.verdict() != Verdict::not_examined && e.verdict() != Verdict::not_decided) continue;
          const std::string why = word_of(e.verdict()) + (e.reason.empty() ? "" : ": " + e.reason);
          const auto same = std::ranges::find_if(lines, [&](const Line& l) { return l.section == s.title && l.why == why; });
          (same != lines.end() ? *same : lines.emplace_back(Line{s.title, why, {}})).claims.push_back(e.claim);
        }
  std::vector<std::string> out;
  for (std::size_t i = 0; i < std::min(lines.size(), most); ++i) {
    std::string claims;
    for (const std::string& c : lines[i].claims) claims += (claims.empty() ? "" : "; ") + c;
    out.push_back(lines[i].section + ": " + claims + " (" + lines[i].why + ").");
  }
  if (lines.size() > most) out.push_back(std::to_string(lines.size() - most) + " more in the sections.");
  if (r.not_asked.empty()) return out;
  out.push_back("Not asked of this report: " + listed(r.not_asked, "and") + ".");
  return out;
}

std::vector<Failure> failures_of(const Report& r) {
  std::vector<Failure> out;
  for (const Check& c : r.checks)
    if (!c.passed) out.push_back({c.name, c.measured, c.limit, c.message, ""});
  for (const Section& s : r.sections)
    for (const Block& block : s.blocks)
      if (const auto* proof = std::get_if<Proof>(&block))
        for (const Evidence& e : proof->lines)
          if (e.failed() && !told_by_a_check(r, e))
            out.push_back({s.title + ": " + e.claim, number_shown(e, e.value), number_shown(e, e.tolerance), how_it_is_shown(e), s.id});
  return out;
}

bool told_by_a_failure(const Report& r, const Finding& f) {
  return std::ranges::any_of(
      r.checks, [&](const Check& c) { return !c.passed && !c.message.empty() && f.text.find(c.message) != std::string::npos; });
}

bool told_by_a_check(const Report& r, const Evidence& line) {
  return std::ranges::any_of(r.checks, [&](const Check& c) { return !c.passed && c.name == line.demanded_by; });
}

}  // namespace pmreport::document
