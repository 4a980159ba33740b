// Section `comparison`: numbers of this report against published ones.
#include <reports/document/quantity.hpp>
#include <reports/section/check_words.hpp>
#include <reports/section/checks.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/comparison/comparison.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;

namespace {

enum class Verdict { reproduces, differs, no_value };

// A row that is judged. Its numbers share one unit: that of the published one as it is written, else that in which it reads best.
struct Judged {
  const ComparisonRow* row;
  double here;
  Verdict verdict;
  DisplayUnit unit;

  std::string deviation() const {
    const double si = here - row->published;
    return row->here.count ? number(si, 0) : typeset(document::rounded(si * unit.per_si));
  }
  std::string number(double si, int digits) const {
    if (row->here.count) return typeset(fmt::format("{:.0f}", si));
    return typeset(format_number(si * unit.per_si, digits));
  }
  std::string with_unit(const std::string& number) const {
    return unit.label.empty() ? number : number + (unit.label == "°" ? "" : " ") + unit.label;
  }
};

Judged judge(const Analysis& a, const ComparisonRow& row, const std::vector<document::Value>& values) {
  const double here = measure(a, row.here, values).value;
  // A deviation that only rounding carries over the tolerance is within it.
  const double slack = 1e-9 * row.tolerance;
  const Verdict verdict = !std::isfinite(here)                                      ? Verdict::no_value
                          : std::abs(here - row.published) <= row.tolerance + slack ? Verdict::reproduces
                                                                                    : Verdict::differs;
  const double size = row.published != 0 ? row.published : std::isfinite(here) ? here : 0;
  return {&row, here, verdict, unit_written(row.written_in).value_or(display_unit(row.here.unit, std::abs(size)))};
}

std::string word_of(Verdict v) {
  switch (v) {
    case Verdict::reproduces:
      return "reproduces";
    case Verdict::differs:
      return "does not reproduce";
    case Verdict::no_value:
      return "no value here";
  }
  return "";
}

std::string superscript(int n) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  for (const char c : std::to_string(n)) out += digits[c - '0'];
  return out;
}

document::Check gate(const Judged& j) {
  const ComparisonRow& r = *j.row;
  const bool agree = r.expected == ComparisonRow::Expected::reproduces;
  document::Check c;
  c.name = r.what + (agree ? ": reproduces " : ": differs from ") + j.with_unit(j.number(r.published, 6));
  c.measured = j.verdict == Verdict::no_value ? "no value" : j.with_unit(j.number(j.here, 6));
  c.limit = fmt::format("{}{}", agree ? "" : "not ",
                        j.with_unit(j.number(r.published, 6) + (r.tolerance > 0 ? " ± " + j.number(r.tolerance, 3) : "")));
  c.value = j.here;
  c.bound = r.published;
  c.unit = r.here.unit;
  c.passed = j.verdict == (agree ? Verdict::reproduces : Verdict::differs);
  c.line = r.line;
  if (c.passed) return c;
  if (j.verdict == Verdict::no_value)
    c.message =
        fmt::format("{}: {} has no value to compare with the published {}", r.what, r.here.that, j.with_unit(j.number(r.published, 6)));
  else
    c.message = fmt::format("{}: {} is {}, published is {}; the scenario says that it {}", r.what, r.here.that, c.measured,
                            j.with_unit(j.number(r.published, 6)), agree ? "reproduces" : "differs");
  return c;
}

// "9 of 11 published values reproduce within their tolerances; 1 does not, and 1 has no value here."
std::string sentence(const std::vector<Judged>& all, const std::string& source) {
  const auto count = [&](Verdict v) {
    return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Judged& j) { return j.verdict == v; }));
  };
  const int total = static_cast<int>(all.size()), good = count(Verdict::reproduces), bad = count(Verdict::differs),
            none = count(Verdict::no_value);
  const std::string of = source.empty() ? "published values" : "values published by " + source;
  std::string out = total == 1      ? fmt::format("The only one of the {} {}", of, good == 1 ? "reproduces within its tolerance" : "")
                    : good == total ? fmt::format("All {} {} reproduce within their tolerances", total, of)
                                    : fmt::format("{} of {} {} reproduce within their tolerances", good, total, of);
  if (total == 1 && good == 0) out = fmt::format("One of the {} is compared", of);
  if (bad > 0) out += fmt::format("; {} not", bad == 1 ? "1 does" : std::to_string(bad) + " do");
  if (none > 0) out += fmt::format("; {} no value here", none == 1 ? "1 has" : std::to_string(none) + " have");
  return out + ".";
}

}  // namespace

Result comparison_section(const Analysis& a, const ComparisonOptions& r, const std::vector<document::Value>& values) {
  Result out{{"comparison", "comparison", "Comparison with published values", {}}, {}, {}, {}};
  std::vector<Judged> all;
  for (const ComparisonRow& row : r.rows) all.push_back(judge(a, row, values));
  out.section.blocks.push_back(Paragraph{Paragraph::Tone::plain, sentence(all, r.source)});

  const bool sources = std::any_of(r.rows.begin(), r.rows.end(), [](const ComparisonRow& row) { return !row.source.empty(); });
  document::Table table{
      "Published values against this report. The deviation is that of this report; a value reproduces when it lies within "
      "the tolerance.",
      {"quantity", "published", "here", "deviation", "tolerance", "unit", "verdict"},
      {false, true, true, true, true, false, false},
      {}};
  if (sources) table.headings.push_back("source"), table.numeric.push_back(false);
  std::vector<Paragraph> notes;
  int reproduced = 0;
  for (const Judged& j : all) {
    const ComparisonRow& row = *j.row;
    const bool valued = j.verdict != Verdict::no_value;
    std::string verdict = word_of(j.verdict);
    if (!row.note.empty()) {
      const std::string mark = superscript(static_cast<int>(notes.size()) + 1);
      verdict += " " + mark;
      notes.push_back({Paragraph::Tone::plain, fmt::format("{} {}: {}.", mark, row.what, row.note)});
      if (row.note.ends_with('.')) notes.back().text.pop_back();
    }
    table.rows.push_back({row.what, j.number(row.published, 6), valued ? j.number(j.here, 6) : "–", valued ? j.deviation() : "–",
                          row.tolerance > 0 ? j.number(row.tolerance, 3) : "exact", j.unit.label, verdict});
    if (sources) table.rows.back().push_back(row.source);
    if (j.verdict == Verdict::reproduces) ++reproduced;
    if (row.expected != ComparisonRow::Expected::nothing) out.checks.push_back(gate(j));
  }
  out.section.blocks.push_back(std::move(table));
  for (Paragraph& note : notes) out.section.blocks.push_back(std::move(note));
  out.findings.push_back(
      {reproduced == static_cast<int>(all.size()) ? document::Finding::Kind::result : document::Finding::Kind::disagreement,
       sentence(all, r.source)});
  out.values.push_back({"comparison", "published", "", static_cast<double>(all.size())});
  out.values.push_back({"comparison", "reproduced", "", static_cast<double>(reproduced)});
  return out;
}

}  // namespace pmreport::section
