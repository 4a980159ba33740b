// Section `classification`: the class of parallel-cross mechanisms.
#include <core/classification/classification.hpp>
#include <reports/section/classification/classification.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using document::Table;

namespace {

Table table_of(const std::string& caption, const std::string& head, const std::vector<classification::SchemeRow>& rows) {
  Table t{caption, {head}, {false}, {}};
  for (int m = 6; m >= 1; --m) t.headings.push_back(fmt::format("m = {}", m)), t.numeric.push_back(false);
  for (const classification::SchemeRow& r : rows) {
    t.rows.push_back({r.head});
    t.rows.back().insert(t.rows.back().end(), r.cells.begin(), r.cells.end());
  }
  return t;
}

Table counts() {
  Table t{"Numbers of schemes by chains k and degrees of freedom m: in Table 1, and, where it differs, by the rule in parentheses.",
          {"k"},
          {false},
          {}};
  for (int m = 6; m >= 1; --m) t.headings.push_back(fmt::format("m = {}", m)), t.numeric.push_back(true);
  t.headings.push_back("all"), t.numeric.push_back(true);
  const auto both = [](int base, int rule) { return base == rule ? std::to_string(base) : fmt::format("{} ({})", base, rule); };
  std::array<int, 7> base{}, rule{};
  for (const classification::SchemeCount& c : classification::scheme_counts()) {
    std::vector<std::string> row{std::to_string(c.chains)};
    int own = 0, by_rule = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      own += c.base[i], by_rule += c.by_rule[i];
      base[i] += c.base[i], rule[i] += c.by_rule[i];
      row.push_back(both(c.base[i], c.by_rule[i]));
    }
    base[6] += own, rule[6] += by_rule;
    row.push_back(both(own, by_rule));
    t.rows.push_back(std::move(row));
  }
  t.rows.push_back({"all"});
  for (std::size_t i = 0; i < 7; ++i) t.rows.back().push_back(both(base[i], rule[i]));
  return t;
}

Table corrections() {
  Table t{"Corrections of the printed tables. Digits within one side have no order.",
          {"table", "k", "m", "printed", "corrected", "why"},
          {false, false, false, false, false, false},
          {}};
  for (const classification::Correction& c : classification::corrections())
    t.rows.push_back({std::to_string(c.table), std::to_string(c.chains), std::to_string(c.freedoms), c.printed.empty() ? "–" : c.printed,
                      c.corrected, c.why});
  return t;
}

}  // namespace

Result classification_section() {
  Result out{{"classification", "classification", "Parallel-cross mechanisms", {}}, {}, {}, {}};
  const std::vector<classification::Scheme> all = classification::admitted_schemes(), &base = classification::base_schemes();
  int six = 0, outside = 0;
  for (const classification::Scheme& s : base) {
    if (s.chains() == 6) ++six;
    if (!admitted(s)) ++outside;
  }
  auto& blocks = out.section.blocks;
  blocks.push_back(Paragraph{
      Paragraph::Tone::plain,
      "Glazunov et al. 2008 join base and platform by k chains, some in parallel and some across, each of these between two parallel ones. "
      "A "
      "scheme is written by the number p of pairs of one freedom in each chain, the parallel chains first: 5556-66. A chain imposes 6 − p "
      "constraints, which leaves m = 6 − Σ(6 − p) degrees of freedom."});
  blocks.push_back(Paragraph{
      Paragraph::Tone::plain,
      fmt::format(
          "The rule: no more chains across than in parallel, and at most one between any two parallel ones; every chain imposes "
          "constraints or contains one of the m drives. It admits {} schemes. {} of them are the base schemes of Table 1 as "
          "corrected below, {} of these have six chains and make up Table 2. The {} marked by a star the paper leaves out without a "
          "reason that it states.",
          all.size(), base.size(), six, all.size() - base.size())});
  blocks.push_back(counts());
  blocks.push_back(table_of("Table 1 of the paper, as corrected. A star marks what the rule admits beyond it.", "k",
                            classification::table_of_base_schemes()));
  blocks.push_back(table_of("Table 2 of the paper, as corrected: six chains, by chains in parallel and across.", "chains",
                            classification::table_of_six_chains()));
  blocks.push_back(corrections());
  document::Proof p;
  p.lines.push_back({"Every base scheme keeps the rule", "base schemes of Table 1, as data, that the rule does not admit",
                     static_cast<double>(outside), 0, ""});
  p.lines.push_back({"Table 1 is complete", "its number of schemes against the 118 that the text of the paper counts",
                     std::abs(static_cast<double>(base.size()) - 118), 0, ""});
  blocks.push_back(std::move(p));
  for (const auto& [name, value] : {std::pair<const char*, std::size_t>{"by_rule", all.size()},
                                    {"base_schemes", base.size()},
                                    {"six_chains", static_cast<std::size_t>(six)}})
    out.values.push_back({"classification", name, "", static_cast<double>(value)});
  return out;
}

}  // namespace pmreport::section
