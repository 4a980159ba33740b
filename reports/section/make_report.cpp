#include <core/text/text.hpp>
#include <reports/document/data/sha256.hpp>
#include <reports/figure/curve.hpp>
#include <reports/section/checks.hpp>
#include <reports/section/common/inputs.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/stage.hpp>
#include <reports/section/common/words/motion_words.hpp>
#include <reports/section/common/words/proof_words.hpp>
#include <reports/section/every_instant/every_instant.hpp>
#include <reports/section/front/front.hpp>
#include <reports/section/front/live_model.hpp>
#include <reports/section/front/model_file.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>
#include <reports/section/overview.hpp>

#include <fmt/core.h>

#include <map>

namespace pmreport::section {

using document::Report;

namespace {

// Minimum and maximum of every column: what a program reads from results.json.
void add_values(Report& r, const Analysis& a, const SectionKind& kind) {
  for (const scenario::Column& c : a.columns_of(kind.columns)) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double x : a.column(c))
      if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    if (low > high) continue;
    r.values.push_back({kind.name, "min(" + c.name + ")", c.unit, low});
    r.values.push_back({kind.name, "max(" + c.name + ")", c.unit, high});
  }
}

// What a section does in chunks is named after it.
Progress progress_of(const scenario::Section& asked, int number, const Progress& progress) {
  Progress out = progress;
  out.part = fmt::format("{} {}", kind_of(asked).name, number);
  return out;
}

// A figure is kept until all are drawn: what of its curves nobody could see is not, of a long motion it is as much as all columns.
document::Section thinned(document::Section section) {
  for (document::Block& block : section.blocks)
    if (auto* figure = std::get_if<figure::Figure>(&block))
      for (figure::Panel& panel : figure->panels)
        for (figure::Series& s : panel.series)
          if (!s.points) figure::thin_out(s.x, s.y);
  return section;
}

}  // namespace

void share_work(const scenario::Loaded& loaded, const Progress& progress) {
  const scenario::Scenario& s = loaded.scenario;
  const mechanics::Machine& m = *loaded.machine;
  chunks::Attempts attempts;
  attempts.add([&] { const Analysis along(s, loaded.trajectory, m, analysis::asked_by(s), progress); });
  const mechanics::Trajectory nowhere;
  const Analysis at_home(s, nowhere, m, {}, {progress.say, progress.stop_if_asked});
  scene::Studio studio;
  const Stage stage(at_home, studio);
  std::map<const scenario::SectionKind*, int> seen;
  for (const scenario::Section& asked : s.sections) {
    const int number = ++seen[asked.kind];
    if (!kind_of(asked).shared) continue;
    progress.stop_if_asked();
    progress.say("section " + asked.kind->name);
    const Progress of_section = progress_of(asked, number, progress);
    attempts.add([&] { kind_of(asked).make({at_home, stage, of_section, {}, number}, asked); });
  }
}

Report make_report(const scenario::Loaded& loaded, const std::string& version, const std::string& build, const Progress& progress) {
  const scenario::Scenario& s = loaded.scenario;
  const mechanics::Machine& m = *loaded.machine;
  progress.say(s.motion ? fmt::format("{} samples of {}", loaded.trajectory.samples(), m.info().name) : m.info().name);
  scene::Studio studio;
  if (s.needs().pictures) studio.prepare();  // while the analysis runs
  Analysis run(s, loaded.trajectory, m, analysis::asked_by(s), progress);
  const Analysis& a = run;

  Report r;
  r.title = s.title;
  r.author = s.author;
  r.description = s.description;
  r.mechanism_title = m.info().title;
  r.source = m.info().source;
  r.scenario_text = s.text;
  r.provenance = {"pmreport", version, m.info().name, one_line(build), s.file.filename().string(), document::sha256(s.text)};

  const Stage stage(a, studio);
  std::optional<Stage::Ordered> cover;
  if (s.needs().pictures) cover = stage.cover();
  std::vector<document::Section> overview = overview_section(a);
  std::map<const scenario::SectionKind*, int> made;  // of each kind
  std::vector<document::Check> gates;
  std::vector<document::Finding> found;
  const auto make = [&](const scenario::Section& asked, int number) {
    const Progress of_section = progress_of(asked, number, progress);
    Result result = kind_of(asked).make({a, stage, of_section, r.values, number}, asked);
    for (document::Value& v : result.values) r.values.push_back(std::move(v));
    for (document::Data& d : result.data) r.data.push_back(std::move(d));
    for (document::File& f : result.files) r.files.push_back(std::move(f));
    for (document::Check& c : result.checks) gates.push_back(std::move(c));
    for (document::Finding& f : result.findings) {
      f.section = result.section.id;
      found.push_back(std::move(f));
    }
    if (!asked.title.empty()) result.section.title = asked.title;
    return thinned(std::move(result.section));
  };
  struct Last {  // a section that needs the values of all others, and where it belongs
    std::size_t index;
    const scenario::Section& asked;
    int number;
  };
  std::vector<Last> last;
  std::vector<std::pair<std::size_t, const SectionKind*>> of_columns;  // data files that get the run's own columns, when nobody needs them
  for (const scenario::Section& asked : s.sections) {
    progress.stop_if_asked();
    const SectionKind& kind = kind_of(asked);
    progress.say("section " + kind.name);
    const int number = ++made[asked.kind];
    const bool later = kind.needs.values_of_others;
    document::Section section;
    if (!later) section = make(asked, number);
    if (kind.columns != nullptr && number == 1) {
      // The overview stands before the first section of curves.
      for (document::Section& o : overview) r.sections.push_back(thinned(std::move(o)));
      overview.clear();
      of_columns.emplace_back(r.data.size(), &kind);
      r.data.emplace_back();
      add_values(r, a, kind);
    }
    if (later) last.push_back({r.sections.size(), asked, number});
    r.sections.push_back(std::move(section));
  }
  for (const Last& l : last) r.sections[l.index] = make(l.asked, l.number);
  r.checks = evaluate_checks(a, r.values);
  const std::vector<analysis::Unseen> unseen = unseen_between_samples(a);
  for (document::Check& c : motion_demands(a, unseen)) r.checks.push_back(std::move(c));
  r.checks.insert(r.checks.end(), gates.begin(), gates.end());
  const Proved p = proved(a);
  if (s.motion) {
    // The last: the sections before keep the order that the scenario gives them, and what they show at the samples it says of every
    // instant.
    AtEveryInstant always = every_instant_section(a, p, unseen);
    r.sections.push_back(std::move(always.section));
    for (document::Data& d : always.data) r.data.push_back(std::move(d));
    r.every_instant = every_instant_results(a, p);
  }
  r.inputs = inputs_of(a);
  put_front(r, a, p, unseen, std::move(found));
  if (s.needs().pictures) {
    r.files.push_back(model_file(a));
    r.live = live_model(a);
  }
  if (cover) r.cover = cover->wait();
  for (const auto& [data, kind] : of_columns) r.data[data] = handed_over(run, kind->name, kind->columns);
  return r;
}

}  // namespace pmreport::section
