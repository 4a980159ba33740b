// From a scenario and its machine to the report.
#include <reports/section/common/limits.hpp>
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words.hpp>
#include <reports/section/section.hpp>

#include <fmt/core.h>
#include <glib.h>

#include <algorithm>
#include <set>

namespace pmreport::section {

using document::Paragraph;
using document::Report;

namespace {

std::string sha256(const std::string& text) {
  gchar* hex = g_compute_checksum_for_data(G_CHECKSUM_SHA256, reinterpret_cast<const guchar*>(text.data()), text.size());
  std::string out(hex);
  g_free(hex);
  return out;
}

std::vector<Paragraph> summary(const Analysis& a, const Report& r) {
  std::vector<Paragraph> out;
  const auto warn = [&](const std::string& text) { out.push_back({Paragraph::Tone::warning, text}); };
  for (const std::string& s : reach_sentences(a)) warn(s);
  for (const std::string& s : singularity_sentences(a)) warn(s);
  for (const LimitBreach& b : a.breaches()) warn(sentence(a, b));
  for (const std::string& s : limit_sentences(a)) warn(s);
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
  const scenario::MotionRequest& motion = *a.scenario().motion;
  const std::string& ending = a.trajectory().ending;
  if (motion.until_singularity && !ending.empty() && a.trajectory().reaches(a.samples() - 1))
    out.push_back({Paragraph::Tone::note, fmt::format("The motion lasts to t = {}, not to the {} asked for, as the scenario allows: it {}.",
                                                      show_time(a, a.samples() - 1), show(motion.end, "s"), ending)});
  tell(fmt::format("{} over {}, {} degrees of freedom.", plural(a.samples(), "sample"), show_time(a, a.samples() - 1), a.machine().dof()));
  tell(fmt::format("Motion: {}.", joined(motion.description)));
  tell(fmt::format("Load on the platform: {}.", joined(a.scenario().load.description)));
  return out;
}

// Minimum and maximum of every column: what a program reads from results.json.
void add_values(Report& r, const Analysis& a, const std::string& section) {
  for (const mechanics::Column& c : a.columns_of(section)) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double x : a.column(c.name))
      if (std::isfinite(x)) low = std::min(low, x), high = std::max(high, x);
    if (low > high) continue;
    r.values.push_back({section, "min(" + c.name + ")", c.unit, low});
    r.values.push_back({section, "max(" + c.name + ")", c.unit, high});
  }
}

}  // namespace

Report make_report(const scenario::Loaded& loaded, const std::string& version, const std::string& build, const Progress& progress) {
  const scenario::Scenario& s = loaded.scenario;
  const mechanics::Machine& m = *loaded.machine;
  progress.say(s.motion ? fmt::format("{} samples of {}", loaded.trajectory.samples(), m.info().name) : m.info().name);
  scene::Studio studio;
  const auto pictures = {"mechanism", "snapshots", "singularity", "assembly"};
  if (std::any_of(pictures.begin(), pictures.end(), [&](const char* kind) { return s.asks_for(kind); }))
    studio.prepare();  // while the analysis runs
  const Analysis a(s, loaded.trajectory, m, analysis::asked_by(s), progress);

  Report r;
  r.title = s.title;
  r.author = s.author;
  r.description = s.description;
  r.mechanism_title = m.info().title;
  r.source = m.info().source;
  r.scenario_text = s.text;
  r.provenance = {"pmreport", version, m.info().name, build, s.file.filename().string(), sha256(s.text)};

  const Stage stage(a, studio);
  std::vector<document::Section> overview = overview_section(a);
  std::set<std::string> data;
  int snapshots = 0;
  std::vector<document::Check> gates;
  const auto take = [&](Result result) {
    for (document::Value& v : result.values) r.values.push_back(std::move(v));
    for (document::Data& d : result.data) r.data.push_back(std::move(d));
    for (document::Check& c : result.checks) gates.push_back(std::move(c));
    return std::move(result.section);
  };
  std::vector<std::pair<std::size_t, const scenario::SectionRequest*>> comparisons;  // where each belongs
  for (const scenario::SectionRequest& request : s.sections) {
    progress.stop_if_asked();
    progress.say("section " + request.kind);
    document::Section section;
    if (request.kind == "mechanism") section = mechanism_section(a, stage);
    if (request.kind == "snapshots") section = snapshots_section(a, request, stage, progress, ++snapshots);
    if (request.kind == "displacement") section = displacement_section(a);
    if (request.kind == "velocity") section = velocity_section(a);
    if (request.kind == "acceleration") section = acceleration_section(a);
    if (request.kind == "statics") section = statics_section(a);
    if (request.kind == "dynamics") section = take(dynamics_section(a, request));
    if (request.kind == "drives") section = take(drives_section(a));
    if (request.kind == "reactions") section = take(reactions_section(a, request));
    if (request.kind == "speed") section = take(speed_section(a));
    if (request.kind == "mobility") section = take(mobility_section(a, request));
    if (request.kind == "singularity") section = take(singularity_section(a, request, stage, progress));
    if (request.kind == "assembly") section = take(assembly_section(a, request, stage, progress));
    if (request.kind == "classification") section = take(classification_section());
    if (!mechanics::columns_of(request.kind, m.topology()).empty() && data.insert(request.kind).second) {
      // The overview stands before the first section of curves.
      for (document::Section& o : overview) r.sections.push_back(std::move(o));
      overview.clear();
      r.data.push_back(data_of(a, request.kind));
      add_values(r, a, request.kind);
    }
    if (request.kind == "comparison") comparisons.emplace_back(r.sections.size(), &request);
    if (!request.title.empty()) section.title = request.title;
    r.sections.push_back(std::move(section));
  }
  // A comparison may name a quantity of any other section.
  for (const auto& [index, request] : comparisons) {
    document::Section section = take(comparison_section(a, *request, r.values));
    if (!request->title.empty()) section.title = request->title;
    r.sections[index] = std::move(section);
  }
  r.checks = evaluate_checks(a, r.values);
  r.checks.insert(r.checks.end(), gates.begin(), gates.end());
  r.summary = summary(a, r);
  return r;
}

}  // namespace pmreport::section
