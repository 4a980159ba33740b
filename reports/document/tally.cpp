#include <reports/document/tally.hpp>

namespace pmreport::document {

Tally tally_checks(const Report& r) {
  Tally tally;
  for (const Check& check : r.checks) {
    ++tally.total;
    if (!check.passed) ++tally.failed;
  }
  return tally;
}

Tally tally_evidence(const Section& s) {
  Tally tally;
  for (const Block& block : s.blocks) {
    const auto* proof = std::get_if<Proof>(&block);
    if (!proof) continue;
    for (const Evidence& line : proof->lines) {
      ++tally.total;
      if (line.failed()) ++tally.failed;
      if (!line.examined) ++tally.not_examined;
    }
  }
  return tally;
}

Tally tally_evidence(const Report& r) {
  Tally tally;
  for (const Section& section : r.sections) {
    const Tally part = tally_evidence(section);
    tally.total += part.total;
    tally.failed += part.failed;
    tally.not_examined += part.not_examined;
  }
  return tally;
}

bool Report::passed() const { return tally_checks(*this).failed == 0 && tally_evidence(*this).failed == 0; }

}  // namespace pmreport::document
