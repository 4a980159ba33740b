#include <reports/document/data/sha256.hpp>
#include <reports/section/checks.hpp>
#include <reports/section/common/limits.hpp>
#include <reports/section/common/motion_words.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/proof_words.hpp>
#include <reports/section/common/remarks.hpp>
#include <reports/section/common/singular_words.hpp>
#include <reports/section/common/stage.hpp>
#include <reports/section/common/words.hpp>
#include <reports/section/every_instant/every_instant.hpp>
#include <reports/section/kinds.hpp>
#include <reports/section/make_report.hpp>
#include <reports/section/overview.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace pmreport::section {

using document::Paragraph;
using document::Report;

namespace {

// What is proved of the motion and no warning tells.
void tell_proof(const Proved& p, std::vector<Paragraph>& out) {
  const bool all = p.proof.unexamined.empty() && std::ranges::all_of(p.proof.claims, [](const ProvedClaim& c) {
                     return c.state == ProvedClaim::State::holds || c.state == ProvedClaim::State::broken;
                   });
  if (std::string sentence = remaining_sentence(p); !sentence.empty())
    out.push_back({all ? Paragraph::Tone::plain : Paragraph::Tone::note, std::move(sentence)});
}

std::vector<Paragraph> summary(const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen, const Report& r) {
  std::vector<Paragraph> out;
  const auto warn = [&](const std::string& text) { out.push_back({Paragraph::Tone::warning, text}); };
  for (const std::string& s : assembly_sentences(a, p)) warn(s);
  for (const std::string& s : singularity_sentences(a)) warn(s);
  for (const std::string& s : nearness_sentences(a)) warn(s);
  for (const std::string& s : jump_sentences(a)) warn(s);
  for (const std::string& s : unseen_sentences(a, unseen)) warn(s);
  for (const std::string& s : range_sentences(a, p)) warn(s);
  for (const std::string& s : limit_sentences(a)) warn(s);
  for (const std::string& s : remark_sentences(a)) warn(s);
  for (const document::Check& c : r.checks)
    if (!c.passed && c.line > 0) warn("Check failed: " + c.message + ".");
  constexpr std::size_t shown = 12;
  if (out.size() > shown) {
    const std::size_t more = out.size() - shown;
    out.resize(shown);
    out.push_back({Paragraph::Tone::warning, fmt::format("{} more in the sections.", plural(static_cast<int>(more), "warning"))});
  }
  const auto joined = [](std::string lines) {
    for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos;) lines.replace(at, 1, at + 1 < lines.size() ? "; " : "");
    return lines;
  };
  const auto tell = [&](const std::string& text) { out.push_back({Paragraph::Tone::plain, text}); };
  if (!a.scenario().motion) {
    tell(fmt::format("No motion is prescribed; {} degrees of freedom.", a.machine().dof()));
    return out;
  }
  tell_proof(p, out);
  const scenario::MotionRequest& motion = *a.scenario().motion;
  const std::string& ending = a.trajectory().ending;
  if (motion.until_singularity && !ending.empty() && a.trajectory().reaches(a.samples() - 1))
    out.push_back({Paragraph::Tone::note, fmt::format("The motion lasts to t = {}, not to the {} asked for, as the scenario allows: it {}.",
                                                      show_time(a, a.samples() - 1), show(motion.end, "s"), ending)});
  for (const std::string& s : acceleration_sentences(a)) out.push_back({Paragraph::Tone::note, s});
  tell(fmt::format("{} over {}, {} degrees of freedom.", plural(a.samples(), "sample"), show_time(a, a.samples() - 1), a.machine().dof()));
  tell(fmt::format("Motion: {}.", joined(motion.description)));
  tell(fmt::format("Load on the platform: {}.", joined(a.scenario().load.description)));
  return out;
}

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
  std::vector<document::Section> overview = overview_section(a);
  std::map<const scenario::SectionKind*, int> made;  // of each kind
  std::vector<document::Check> gates;
  std::vector<std::string> found;
  const auto make = [&](const scenario::Section& asked, int number) {
    Result result = kind_of(asked).make({a, stage, progress, r.values, number}, asked);
    for (document::Value& v : result.values) r.values.push_back(std::move(v));
    for (document::Data& d : result.data) r.data.push_back(std::move(d));
    for (document::File& f : result.files) r.files.push_back(std::move(f));
    for (document::Check& c : result.checks) gates.push_back(std::move(c));
    for (std::string& sentence : result.summary) found.push_back(std::move(sentence));
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
  r.summary = summary(a, p, unseen, r);
  for (std::string& sentence : found) r.summary.push_back({Paragraph::Tone::plain, std::move(sentence)});
  return r;
}

}  // namespace pmreport::section
