#include <reports/document/data/sha256.hpp>
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

}  // namespace

Report make_report(const scenario::Loaded& loaded, const std::string& version, const std::string& build, const Progress& progress) {
  const scenario::Scenario& s = loaded.scenario;
  const mechanics::Machine& m = *loaded.machine;
  progress.say(s.motion ? fmt::format("{} samples of {}", loaded.trajectory.samples(), m.info().name) : m.info().name);
  scene::Studio studio;
  if (s.needs().pictures) studio.prepare();  // while the analysis runs
  const Analysis a(s, loaded.trajectory, m, analysis::asked_by(s), progress);

  Report r;
  r.title = s.title;
  r.author = s.author;
  r.description = s.description;
  r.mechanism_title = m.info().title;
  r.source = m.info().source;
  r.scenario_text = s.text;
  r.provenance = {"pmreport", version, m.info().name, build, s.file.filename().string(), document::sha256(s.text)};

  const Stage stage(a, studio);
  std::optional<Stage::Ordered> cover;
  if (s.needs().pictures) cover = stage.cover();
  std::vector<document::Section> overview = overview_section(a);
  std::map<const scenario::SectionKind*, int> made;  // of each kind
  std::vector<document::Check> gates;
  std::vector<document::Finding> found;
  const auto make = [&](const scenario::Section& asked, int number) {
    Result result = kind_of(asked).make({a, stage, progress, r.values, number}, asked);
    for (document::Value& v : result.values) r.values.push_back(std::move(v));
    for (document::Data& d : result.data) r.data.push_back(std::move(d));
    for (document::File& f : result.files) r.files.push_back(std::move(f));
    for (document::Check& c : result.checks) gates.push_back(std::move(c));
    for (document::Finding& f : result.findings) {
      f.section = result.section.id;
      found.push_back(std::move(f));
    }
    if (!asked.title.empty()) result.section.title = asked.title;
    return std::move(result.section);
  };
  struct Last {  // a section that needs the values of all others, and where it belongs
    std::size_t index;
    const scenario::Section& asked;
    int number;
  };
  std::vector<Last> last;
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
      for (document::Section& o : overview) r.sections.push_back(std::move(o));
      overview.clear();
      r.data.push_back(data_of(a, kind.name, kind.columns));
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
  return r;
}

}  // namespace pmreport::section
