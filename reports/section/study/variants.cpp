// Machines side by side.
#include <reports/section/study/study.hpp>

#include <reports/section/common/words/words.hpp>
#include <reports/section/study/extremes.hpp>
#include <reports/section/study/words.hpp>

#include <core/analysis/design/judge_all.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;

namespace {

// Of the variant's own mechanism and workspace, by the length of this scenario's.
Judged judge_variant(const Analysis& a, const StudyOptions& o, const StudiedVariant& v, const Progress& progress) {
  analysis::MachineStudy study = study_of(a, o);
  study.requests = v.requests;
  const mechanics::Machine& origin = v.other ? *v.other->machine : a.machine();
  try {
    return analysis::judge(*origin.with(v.parameters), study, progress);
  } catch (const mechanics::MechanismError& e) {
    if (e.status != PM_BAD_ARGUMENT) throw;
    return {{}, e.what()};
  }
}

std::string parameter_words(const mechanics::ParameterInfo& info, const std::vector<double>& value) {
  if (info.kind == PM_CHOICE) return fmt::format("{} = {}", info.name, info.choices[static_cast<std::size_t>(value.front())]);
  if (info.kind == PM_NUMBERS) return fmt::format("{} of {}", info.name, plural(static_cast<int>(value.size()), "number"));
  return fmt::format("{} = {}", info.name, show(value.front(), info.unit, 6));
}

std::string machine_words(const Analysis& a, const StudiedVariant& v) {
  const mechanics::MechanismInfo& info = v.other ? v.other->machine->info() : a.machine().info();
  std::string out = info.name;
  for (const std::size_t i : v.changed) out += ", " + parameter_words(info.parameters[i], v.parameters[i]);
  if (!v.file.empty()) out += fmt::format(" ({})", printable(v.file));
  return out;
}

// A row each, the first at the top.
figure::Figure figure_of(const StudyOptions& o, const std::vector<const Judged*>& all) {
  figure::Figure out{"study", "The machines by each of their numbers; where a bracket is wider than a dot, a line shows it.",
                     "",      figure::Width::full,
                     2,       {}};
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    const DisplayUnit unit = unit_of(o, n, all);
    figure::Panel p;
    p.title = title_of(o, n);
    p.x = {label_of(o, n), unit.label};
    for (std::size_t k = all.size(); k-- > 0;) p.y.names.push_back(o.variants[k].name);
    figure::Series points{"", {}, {}, 0, true}, lines{"", {}, {}, 0};
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (n >= all[k]->numbers.size() || !all[k]->numbers[n].known()) continue;
      const Bracketed& x = all[k]->numbers[n];
      const auto row = static_cast<double>(all.size() - 1 - k);
      points.x.push_back(x.value * unit.per_si), points.y.push_back(row);
      for (const double end : {x.low * unit.per_si, x.high * unit.per_si, std::nan("")}) lines.x.push_back(end), lines.y.push_back(row);
    }
    if (std::ranges::any_of(all, [&](const Judged* j) { return n < j->numbers.size() && j->numbers[n].width() > 0; }))
      p.series.push_back(std::move(lines));
    p.series.push_back(std::move(points));
    out.panels.push_back(std::move(p));
  }
  if (out.panels.size() == 1) out.width = figure::Width::column, out.columns = 1;
  return out;
}

document::Table table_of(const Analysis& a, const StudyOptions& o, const std::vector<const Judged*>& all) {
  document::Table out{"The machines.", {"variant", "machine"}, {false, false}, {}};
  std::vector<DisplayUnit> units;
  for (std::size_t n = 0; n < o.numbers.size(); ++n) {
    units.push_back(unit_of(o, n, all));
    out.headings.push_back(heading(label_of(o, n), units.back()));
    out.numeric.push_back(true);
  }
  const bool remarks = std::ranges::any_of(all, [](const Judged* j) { return !remark(*j).empty(); });
  if (remarks) out.headings.push_back("remark"), out.numeric.push_back(false);
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::vector<std::string> row{o.variants[k].name, machine_words(a, o.variants[k])};
    for (std::size_t n = 0; n < o.numbers.size(); ++n) row.push_back(cell(all[k]->numbers, n, units[n]));
    if (remarks) row.push_back(remark(*all[k]));
    out.rows.push_back(std::move(row));
  }
  return out;
}

}  // namespace

void add_variants(const Analysis& a, const StudyOptions& o, const Progress& progress, Result& out) {
  progress.say(fmt::format("study: {}", plural(static_cast<int>(o.variants.size()), "machine")));
  chunks::Meaning meaning;  // the other scenarios, which this one only names
  for (const StudiedVariant& v : o.variants)
    if (v.other) meaning << v.other->scenario.text;
  const std::vector<Judged> judged = analysis::judge_all(
      {progress.part + " machines", meaning.value()}, o.variants.size(),
      [&](std::size_t k) { return judge_variant(a, o, o.variants[k], progress); }, progress);
  std::vector<const Judged*> all;
  for (const Judged& j : judged) all.push_back(&j);

  auto& blocks = out.section.blocks;
  if (std::string f = failures(all); !f.empty()) blocks.push_back(Paragraph{Paragraph::Tone::warning, std::move(f)});
  if (std::string s = cut_off(all); !s.empty()) blocks.push_back(Paragraph{Paragraph::Tone::note, std::move(s)});
  for (std::size_t n = 0; n < o.numbers.size(); ++n)
    blocks.push_back(
        Paragraph{Paragraph::Tone::plain, extremes_sentence(o, n, all, [&](std::size_t k) { return "of " + o.variants[k].name; })});
  blocks.push_back(table_of(a, o, all));
  if (std::ranges::any_of(all, [](const Judged* j) { return j->made(); })) blocks.push_back(figure_of(o, all));

  document::Data data;
  data.headings = {"variant", "machine", "remark"};
  data.words.resize(3);
  for (std::size_t k = 0; k < judged.size(); ++k) {
    data.words[0].push_back(o.variants[k].name);
    data.words[1].push_back(machine_words(a, o.variants[k]));
    data.words[2].push_back(remark(judged[k]));
  }
  add_columns(o, all, data);
  out.data.push_back(std::move(data));
  add_values_of_variants(o, all, judged.size(), out);
}

}  // namespace pmreport::section
