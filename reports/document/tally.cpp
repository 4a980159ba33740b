#include <reports/document/tally.hpp>

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

bool told_by_a_check(const Report& r, const Evidence& line) {
  return std::ranges::any_of(r.checks, [&](const Check& c) { return !c.passed && c.name == line.demanded_by; });
}

}  // namespace pmreport::document
