#include <fmt/format.h>
#include <reports/document/write.hpp>

#include <reports/document/finding.hpp>
#include <reports/document/names.hpp>
#include <reports/document/tally.hpp>
#include <reports/document/text.hpp>

namespace pmreport::document {

namespace {

int skipped(const Tally& tally) { return tally[Verdict::not_decided] + tally[Verdict::not_examined] + tally[Verdict::not_applicable]; }

std::string attributes(const std::string& name, const Tally& tally) {
  return fmt::format("name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\"", escape(name), tally.total(),
                     tally[Verdict::failed], tally[Verdict::error], skipped(tally));
}

// What was measured and what was asked stand with every case, passed or not: a trend is read from them before anything breaks.
std::string outcome(Verdict verdict, const char* type, const std::string& finding, const std::string& detail) {
  const std::string text = detail.empty() ? finding : finding + "\n" + detail;
  const auto broken = [&](const char* element) {
    return fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", element, type, escape(finding), escape(text));
  };
  switch (verdict) {
    case Verdict::passed:
      return fmt::format("      <system-out>{}</system-out>\n", escape(text));
    case Verdict::failed:
      return broken("failure");
    case Verdict::error:
      return broken("error");
    case Verdict::not_decided:
    case Verdict::not_examined:
    case Verdict::not_applicable:
      break;
  }
  return fmt::format("      <skipped message=\"{}\"/>\n", escape(text));
}

std::string to_case(const Check& check, const std::string& scenario) {
  const std::string place = check.line > 0 ? fmt::format(" file=\"{}\" line=\"{}\"", escape(scenario), check.line) : "";
  return fmt::format("    <testcase name=\"{}\" classname=\"checks\"{}>\n{}    </testcase>\n", escape(check.name), place,
                     outcome(check.passed ? Verdict::passed : Verdict::failed, "check",
                             "measured " + check.measured + ", limit " + check.limit, check.message));
}

std::string to_case(const Evidence& line, const std::string& section) {
  return fmt::format("    <testcase name=\"{}\" classname=\"{}\">\n{}    </testcase>\n", escape(line.claim), section,
                     outcome(line.verdict(), "evidence", finding(line), line.how));
}

}  // namespace

std::string to_junit(const Report& r) {
  const Names names = names_of(r);
  const Tally checks = tally_checks(r);
  Tally all = tally_evidence(r);
  all += checks;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + attributes(r.title, all) + ">\n";
  if (checks.total() > 0) {
    out += "  <testsuite " + attributes("checks", checks) + ">\n";
    for (const Check& check : r.checks) out += to_case(check, r.provenance.scenario_name);
    out += "  </testsuite>\n";
  }
  for (std::size_t s = 0; s < r.sections.size(); ++s) {
    const Tally tally = tally_evidence(r.sections[s]);
    if (tally.total() == 0) continue;
    out += "  <testsuite " + attributes(names.sections[s], tally) + ">\n";
    for (const Block& block : r.sections[s].blocks) {
      const auto* proof = std::get_if<Proof>(&block);
      if (!proof) continue;
      for (const Evidence& line : proof->lines) out += to_case(line, names.sections[s]);
    }
    out += "  </testsuite>\n";
  }
  return out + "</testsuites>\n";
}

}  // namespace pmreport::document
