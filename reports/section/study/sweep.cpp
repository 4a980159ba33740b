// A study over one or two parameters.
#include <reports/section/study/study.hpp>

#include <reports/section/common/words/words.hpp>
#include <reports/section/study/extremes.hpp>
#include <reports/section/study/words.hpp>

#include <core/numbers.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

namespace pmreport::section {

using analysis::Sweep;
using document::Paragraph;

namespace {

constexpr std::size_t most_rows = 40;  // of a table: more are left to the data file
constexpr double seen = 5e-3;          // of a panel's height: a bracket that is narrower is not drawn

std::vector<const Judged*> pointers(const Sweep& s) {
  std::vector<const Judged*> out;
  for (const Judged& j : s.judged) out.push_back(&j);
  return out;
}

document::Table table_of(const StudyOptions& o, const Sweep& s, const std::vector<const Judged*>& all) {
  document::Table out{"Every variant.", {}, {}, {}};
  std::vector<DisplayUnit> parameters, numbers;
  const auto add = [&](std::string heading, bool numeric) {
    out.headings.push_back(std::move(heading));
    out.numeric.push_back(numeric);
  };
  for (const StudiedParameter& p : o.over) {
    parameters.push_back(unit_of(p));
    add(heading(p.name, parameters.back()), true);
  }
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    numbers.push_back(unit_of(o, n, all));
    add(heading(label_of(o, n), numbers.back()), true);
  }
  const bool remarks = std::ranges::any_of(all, [](const Judged* j) { return !remark(*j).empty(); });
  if (remarks) add("remark", false);
  for (std::size_t k = 0; k < s.values.size(); ++k) {
    std::vector<std::string> row;
    for (std::size_t i = 0; i < o.over.size(); ++i) row.push_back(typeset(format_number(s.values[k][i] * parameters[i].per_si, 6)));
    for (std::size_t n = 0; n < o.numbers.size(); ++n) row.push_back(cell(s.judged[k].numbers, n, numbers[n]));
    if (remarks) row.push_back(remark(s.judged[k]));
    out.rows.push_back(std::move(row));
  }
  return out;
}

double number_of(const Judged& j, std::size_t n, double Bracketed::*part) { return n < j.numbers.size() ? j.numbers[n].*part : nan; }

// Variants that could not be judged lie between their neighbours.
std::vector<figure::Band> gaps(const StudyOptions& o, const Sweep& s, double per_si) {
  std::vector<figure::Band> out;
  const double half = 0.5 * (o.over[0].to - o.over[0].from) / static_cast<double>(o.over[0].count - 1);
  for (std::size_t k = 0; k < s.values.size(); ++k) {
    if (s.judged[k].made()) continue;
    const double x = s.values[k][0], from = std::max(x - half, o.over[0].from) * per_si, to = std::min(x + half, o.over[0].to) * per_si;
    if (!out.empty() && out.back().to >= from - 1e-9 * std::abs(from))
      out.back().to = to;
    else
      out.push_back({from, to, figure::Band::Kind::unreachable});
  }
  return out;
}

figure::Panel curve_of(const StudyOptions& o, const Sweep& s, std::size_t n, const Judged& own, const std::vector<const Judged*>& all) {
  const DisplayUnit x = unit_of(o.over[0]), y = unit_of(o, n, all);
  figure::Panel out;
  out.title = title_of(o, n);
  out.x = {o.over[0].name, x.label};
  out.y = {label_of(o, n), y.label};
  figure::Series value{"", {}, {}, 0}, low{"", {}, {}, 1}, high{"", {}, {}, 1};
  double least = std::numeric_limits<double>::infinity(), most = -least, widest = 0;
  for (std::size_t k = 0; k < s.values.size(); ++k) {
    const double at = s.values[k][0] * x.per_si, v = number_of(s.judged[k], n, &Bracketed::value) * y.per_si;
    const double from = number_of(s.judged[k], n, &Bracketed::low) * y.per_si, to = number_of(s.judged[k], n, &Bracketed::high) * y.per_si;
    for (auto* series : {&value, &low, &high}) series->x.push_back(at);
    value.y.push_back(v), low.y.push_back(from), high.y.push_back(to);
    if (!std::isfinite(v)) continue;
    least = std::min(least, from), most = std::max(most, to), widest = std::max(widest, to - from);
  }
  figure::Series marks = value;
  marks.points = true;
  out.series.push_back(std::move(value));
  out.series.push_back(std::move(marks));
  if (widest > seen * (most - least) && most > least) {
    low.label = "bracket";
    out.series.push_back(std::move(low));
    out.series.push_back(std::move(high));
  }
  if (o.over[0].own >= o.over[0].from && o.over[0].own <= o.over[0].to && n < own.numbers.size() && own.numbers[n].known())
    out.series.push_back({"this scenario", {o.over[0].own * x.per_si}, {own.numbers[n].value * y.per_si}, 3, true});
  out.bands = gaps(o, s, x.per_si);
  return out;
}

figure::Panel map_of(const StudyOptions& o, const Sweep& s, std::size_t n, const std::vector<const Judged*>& all) {
  const DisplayUnit x = unit_of(o.over[0]), y = unit_of(o.over[1]), z = unit_of(o, n, all);
  figure::Panel out;
  out.title = title_of(o, n);
  out.x = {o.over[0].name, x.label};
  out.y = {o.over[1].name, y.label};
  figure::ColourMap map;
  map.scale = figure::ColourMap::Scale::sequential;
  map.bar = {label_of(o, n), z.label};
  const std::size_t columns = o.over[0].count, rows = o.over[1].count;
  for (std::size_t i = 0; i < columns; ++i) map.x.push_back(s.values[i * rows][0] * x.per_si);
  for (std::size_t j = 0; j < rows; ++j) map.y.push_back(s.values[j][1] * y.per_si);
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) map.values.push_back(number_of(s.judged[i * rows + j], n, &Bracketed::value) * z.per_si);
  out.map = std::move(map);
  const bool inside = std::ranges::all_of(o.over, [](const StudiedParameter& p) { return p.own >= p.from && p.own <= p.to; });
  if (inside) out.series.push_back({"this scenario", {o.over[0].own * x.per_si}, {o.over[1].own * y.per_si}, 0, true});
  return out;
}

figure::Figure figure_of(const StudyOptions& o, const Sweep& s, const Judged& own, const std::vector<const Judged*>& all) {
  figure::Figure out{"study", "", "", figure::Width::full, 2, {}};
  std::vector<std::string> titles;
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    titles.push_back(title_of(o, n));
    out.panels.push_back(o.over.size() == 1 ? curve_of(o, s, n, own, all) : map_of(o, s, n, all));
  }
  std::vector<std::string> names;
  for (const StudiedParameter& p : o.over) names.push_back(p.name);
  out.caption = fmt::format("{} over {}{}.", listed(titles, "and"), listed(names, "and"),
                            o.over.size() == 1 ? "; a dot is a variant" : "; between the variants the colours are interpolated");
  out.caption.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(out.caption.front())));
  if (std::ranges::any_of(all, [](const Judged* j) { return !j->made(); }))
    out.caption += " Grey: variants that could not be made or judged.";
  if (out.panels.size() == 1 && o.over.size() == 1) out.width = figure::Width::column, out.columns = 1;
  return out;
}

}  // namespace

void add_sweep(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out) {
  std::vector<analysis::SweptVariable> variables;
  std::size_t count = 1;
  for (const StudiedParameter& p : o.over) variables.push_back({p.from, p.to, p.count}), count *= p.count;
  const analysis::Judge judge = judge_of(a, o, study_of(a, o), progress);
  const Judged own = judge_own(judge, o, count, progress);
  const Sweep s = analysis::sweep(variables, judge, progress);
  const std::vector<const Judged*> all = pointers(s);

  auto& blocks = out.section.blocks;
  std::vector<std::string> names;
  for (const StudiedParameter& p : o.over)
    names.push_back(fmt::format("{} ({}) from {} to {}", p.name, p.title, show(p.from, p.unit, 5), show(p.to, p.unit, 5)));
  blocks.push_back(Paragraph{Paragraph::Tone::plain,
                             fmt::format("{} of {}: {}; all else is as the scenario has it.", plural(static_cast<int>(count), "variant"),
                                         a.machine().info().name, listed(names, "and"))});
  if (std::string f = failures(all); !f.empty()) blocks.push_back(Paragraph{Paragraph::Tone::warning, std::move(f)});
  if (std::string s = cut_off(all); !s.empty()) blocks.push_back(Paragraph{Paragraph::Tone::note, std::move(s)});
  for (std::size_t n = 0; n < o.numbers.size(); ++n)
    blocks.push_back(
        Paragraph{Paragraph::Tone::plain, extremes_sentence(o, n, all, [&](std::size_t k) { return "at " + place_of(o, s.values[k]); })});
  if (std::ranges::any_of(all, [](const Judged* j) { return j->made(); })) blocks.push_back(figure_of(o, s, own, all));
  if (count <= most_rows) blocks.push_back(table_of(o, s, all));

  document::Data data;
  data.words.emplace_back();
  data.headings.push_back("remark");
  for (const Judged& j : s.judged) data.words[0].push_back(remark(j));
  for (std::size_t i = 0; i < o.over.size(); ++i) {
    data.headings.push_back(o.over[i].name + (o.over[i].unit.empty() ? "" : " [" + o.over[i].unit + "]"));
    data.columns.emplace_back();
    for (const auto& v : s.values) data.columns.back().push_back(v[i]);
  }
  add_columns(o, all, data);
  out.data.push_back(std::move(data));
  add_values_of_variants(o, all, most_variants_told, out);
}

}  // namespace pmreport::section
