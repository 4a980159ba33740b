#include <reports/compare/words.hpp>

#include <core/text/digits.hpp>
#include <core/text/text.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace pmreport::compare {

namespace {

constexpr const char* absent = "–";
constexpr int digits = 6, digits_of_a_difference = 3;

std::string with_unit(const std::string& name, const std::string& unit) { return unit.empty() ? name : name + " [" + unit + "]"; }
std::string difference_in_words(double difference) {
  return std::isnan(difference) ? absent : format_number(difference, digits_of_a_difference);
}
std::string plural(std::size_t n, const char* one, const char* many) { return fmt::format("{} {}", n, n == 1 ? one : many); }

// The numbers of a row with the digits that set them apart.
std::vector<std::string> cells_of(const ValueRow& row) {
  std::vector<double> numbers;
  for (const auto& cell : row.cells) numbers.push_back(cell ? cell->value : std::numeric_limits<double>::quiet_NaN());
  std::vector<std::string> out = format_together(numbers, digits, 2);
  for (std::size_t r = 0; r < out.size(); ++r) {
    if (!row.cells[r])
      out[r] = absent;
    else if (std::isnan(numbers[r]))
      out[r] = row.cells[r]->status;
  }
  return out;
}

std::size_t owners(const ValueRow& row) {
  return static_cast<std::size_t>(std::ranges::count_if(row.cells, [](const auto& cell) { return cell.has_value(); }));
}
std::size_t owners(const JudgementRow& row) {
  return static_cast<std::size_t>(std::ranges::count_if(row.states, [](const auto& state) { return state.has_value(); }));
}
std::size_t owners(const CurveRow& row) {
  return static_cast<std::size_t>(std::ranges::count_if(row.sources, [](const auto& source) { return source.has_value(); }));
}

struct Count {
  std::size_t shared = 0, differing = 0, not_in_all = 0;
};
template <class Row>
Count count(const std::vector<Row>& rows) {
  Count out;
  for (const Row& row : rows) {
    if (owners(row) > 1) ++out.shared;
    if (row.differs) ++out.differing;
    if (!row.everywhere) ++out.not_in_all;
  }
  return out;
}

struct Kind {
  Count count;
  const char *one, *many;
};
std::vector<Kind> kinds(const Comparison& c) {
  return {{count(c.values), "value", "values"}, {count(c.judgements), "verdict", "verdicts"}, {count(c.curves), "curve", "curves"}};
}

bool other_instants(const Comparison& c) {
  return std::ranges::any_of(c.curves, [](const CurveRow& row) { return row.other_instants; });
}

// The different ones among what `of` says of each report, in their order.
template <class Of>
std::vector<std::string> distinct(const Comparison& c, Of of) {
  std::vector<std::string> out;
  for (const Results* r : c.reports)
    if (const std::string word = of(*r); std::ranges::find(out, word) == out.end()) out.push_back(word);
  return out;
}

std::vector<std::string> headings_with_letters(std::vector<std::string> before, const Comparison& c, std::vector<std::string> after) {
  for (std::size_t r = 0; r < c.reports.size(); ++r) before.push_back(letter(r));
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

document::Table table(std::string caption, std::vector<std::string> headings, std::vector<bool> numeric) {
  document::Table out;
  out.caption = std::move(caption);
  out.headings = std::move(headings);
  out.numeric = std::move(numeric);
  return out;
}

std::vector<document::Table> only_if_filled(document::Table t) {
  return t.rows.empty() ? std::vector<document::Table>{} : std::vector<document::Table>{std::move(t)};
}

}  // namespace

std::string letter(std::size_t report) { return std::string(1, static_cast<char>('A' + report)); }

std::string verdict(const Comparison& c) {
  const std::string tolerance = fmt::format("a relative {} or an absolute {} (SI)", format_number(c.tolerance.relative, digits),
                                            format_number(c.tolerance.absolute, digits));
  std::vector<std::string> shared, differing, not_in_all;
  bool any = false;
  for (const Kind& kind : kinds(c)) {
    any = any || kind.count.shared > 0;
    if (kind.count.shared > 0) shared.push_back(plural(kind.count.shared, kind.one, kind.many));
    if (kind.count.differing > 0)
      differing.push_back(fmt::format("{} of {}", kind.count.differing, plural(kind.count.shared, kind.one, kind.many)));
    if (kind.count.not_in_all > 0) not_in_all.push_back(plural(kind.count.not_in_all, kind.one, kind.many));
  }
  if (c.agree) return any ? fmt::format("They agree: {}, within {}.", listed(shared), tolerance) : "They agree: none of them has a value.";
  std::string out = "They differ: ";
  if (!differing.empty())
    out += fmt::format("{}.", listed(differing));
  else if (any)
    out += "what they share agrees.";
  else
    out += "they share nothing.";
  if (!not_in_all.empty()) out += fmt::format(" Not in {}: {}.", c.reports.size() == 2 ? "both" : "all", listed(not_in_all));
  if (other_instants(c)) out += " Curves are sampled at other instants.";
  if (any) out += fmt::format(" Numbers agree within {}.", tolerance);
  return out;
}

std::vector<std::string> remarks(const Comparison& c) {
  std::vector<std::string> out;
  const auto mechanisms = distinct(c, [](const Results&r) { return r.mechanism; }),
             scenarios = distinct(c, [](const Results&r) { return r.scenario; }),
             hashes = distinct(c, [](const Results&r) { return r.scenario_sha256; }),
             programs = distinct(c, [](const Results&r) { return fmt::format("pmreport {}, plugin {}", r.version, r.plugin_build); });
  if (mechanisms.size() > 1)
    out.push_back(fmt::format(
        "These are reports of different mechanisms, {}: what has the same section, name and unit in them may mean something else in each.",
        listed(mechanisms)));
  else if (hashes.size() > 1)
    out.push_back(scenarios.size() > 1 ? fmt::format("These are reports of different scenarios, {}.", listed(scenarios))
                                       : fmt::format("These are reports of different scenarios, all named {}.", scenarios.front()));
  if (programs.size() > 1) out.push_back(fmt::format("They were made by different programs: {}.", listed(programs)));
  for (std::size_t r = 0; r < c.reports.size(); ++r)
    if (!c.reports[r]->curves_missing.empty())
      out.push_back(fmt::format("Curves of {} are not all compared: {}.", letter(r), c.reports[r]->curves_missing));
  if (other_instants(c)) out.emplace_back("Between instants at which a report was sampled its curves are taken as straight lines.");
  return out;
}

document::Table reports_table(const Comparison& c) {
  document::Table out = table("", {"", "result", "report", "mechanism", "scenario", "title"}, {false, false, false, false, false, false});
  for (std::size_t r = 0; r < c.reports.size(); ++r) {
    const Results& results = *c.reports[r];
    out.rows.push_back(
        {letter(r), results.passed ? "passed" : "failed", results.label, results.mechanism, results.scenario, results.title});
  }
  return out;
}

std::vector<document::Table> value_tables(const Comparison& c) {
  const bool two = c.reports.size() == 2;
  std::vector<document::Table> out;
  for (const ValueRow& row : c.values) {
    if (owners(row) < 2 || (two && !row.differs)) continue;
    if (out.empty() || out.back().caption != row.section) {
      out.push_back(table(row.section, headings_with_letters({"value"}, c, {"difference", "relative"}), {false}));
      out.back().numeric.resize(out.back().headings.size(), true);
      if (!two) out.back().headings.push_back("verdict"), out.back().numeric.push_back(false);
    }
    std::vector<std::string> cells = cells_of(row);
    cells.insert(cells.begin(), with_unit(row.name, row.unit));
    cells.push_back(difference_in_words(row.difference));
    cells.push_back(difference_in_words(row.relative));
    if (!two) cells.push_back(row.differs ? "differs" : "agrees");
    out.back().rows.push_back(std::move(cells));
  }
  return out;
}

std::vector<document::Table> judgement_tables(const Comparison& c) {
  document::Table out = table("Checks and evidence that differ", headings_with_letters({}, c, {"section", "check or claim"}), {});
  out.numeric.resize(out.headings.size(), false);
  for (const bool changed : {true, false})  // what has another verdict before what not all have
    for (const JudgementRow& row : c.judgements) {
      if (row.differs != changed || (row.everywhere && !row.differs)) continue;
      std::vector<std::string> cells;
      for (const auto& state : row.states) cells.push_back(state.value_or(absent));
      cells.push_back(row.section);
      cells.push_back(row.name);
      out.rows.push_back(std::move(cells));
    }
  return only_if_filled(std::move(out));
}

std::vector<document::Table> curve_tables(const Comparison& c) {
  document::Table out = table("Curves that differ", {"section", "curve", "difference", "at t [s]", "relative", "remark"},
                              {false, false, true, true, true, false});
  for (const CurveRow& row : c.curves) {
    if (owners(row) < 2 || (!row.differs && !row.other_instants)) continue;
    out.rows.push_back({row.section, row.heading, difference_in_words(row.difference),
                        row.difference == 0 ? absent : format_number(row.at, digits), difference_in_words(row.relative),
                        row.gap              ? "a gap in one of them"
                        : row.other_instants ? "other instants"
                                             : ""});
  }
  return only_if_filled(std::move(out));
}

std::vector<document::Table> lone_tables(const Comparison& c) {
  std::vector<document::Table> out;
  for (std::size_t r = 0; r < c.reports.size(); ++r) {
    document::Table alone = table("Only in " + letter(r), {"section", "value or curve", letter(r)}, {false, false, true});
    for (const ValueRow& row : c.values)
      if (!row.everywhere && owners(row) == 1 && row.cells[r])
        alone.rows.push_back({row.section, with_unit(row.name, row.unit), cells_of(row)[r]});
    for (const CurveRow& row : c.curves)
      if (!row.everywhere && owners(row) == 1 && row.sources[r]) alone.rows.push_back({row.section, row.heading, "curve"});
    if (!alone.rows.empty()) out.push_back(std::move(alone));
  }
  return out;
}

std::vector<std::string> baseline_lines(const Comparison& c) {
  std::vector<std::string> out;
  for (const ValueRow& row : c.values) {
    if (row.everywhere && !row.differs) continue;
    const std::vector<std::string> cells = cells_of(row);
    const std::string name = fmt::format("{} {}", row.section, with_unit(row.name, row.unit));
    if (!row.cells[1])
      out.push_back(fmt::format("{}: not here, in the baseline {}", name, cells[0]));
    else if (!row.cells[0])
      out.push_back(fmt::format("{}: {}, not in the baseline", name, cells[1]));
    else if (std::isnan(row.difference))
      out.push_back(fmt::format("{}: {}, in the baseline {}", name, cells[1], cells[0]));
    else
      out.push_back(fmt::format("{}: {}, in the baseline {}; difference {}, relative {}", name, cells[1], cells[0],
                                difference_in_words(row.difference), difference_in_words(row.relative)));
  }
  for (const JudgementRow& row : c.judgements)
    if (!row.everywhere || row.differs)
      out.push_back(fmt::format("{}: {}: {}, {}", row.section, row.name, row.states[1].value_or("not here"),
                                row.states[0] ? "in the baseline " + *row.states[0] : "not in the baseline"));
  for (const CurveRow& row : c.curves) {
    if (row.everywhere && !row.differs && !row.other_instants) continue;
    const std::string name = fmt::format("{} curve {}", row.section, row.heading);
    if (!row.everywhere)
      out.push_back(fmt::format("{}: not {}", name, row.sources[1] ? "in the baseline" : "here, in the baseline it is"));
    else if (row.gap)
      out.push_back(fmt::format("{}: a gap where the other has a value", name));
    else if (row.differs)
      out.push_back(fmt::format("{}: off by {} at t = {} s, relative {}", name, difference_in_words(row.difference),
                                format_number(row.at, digits), difference_in_words(row.relative)));
    else
      out.push_back(fmt::format("{}: sampled at other instants", name));
  }
  for (std::string& line : out) line = printable(line);
  return out;
}

}  // namespace pmreport::compare
