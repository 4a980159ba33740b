#include <reports/section/front/front.hpp>

#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/motion_words.hpp>
#include <reports/section/common/words/remarks.hpp>
#include <reports/section/common/words/singular_words.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/front/key_numbers.hpp>
#include <reports/section/front/surprises.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Finding;
using document::Paragraph;
using document::Report;

namespace {

// Of the first section of the kinds, in their order of preference.
std::string section_of(const Report& r, std::initializer_list<const char*> kinds) {
  for (const char* kind : kinds)
    for (const document::Section& s : r.sections)
      if (s.kind == kind) return s.id;
  return "";
}

void add_faults(Report& r, const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen) {
  const auto add = [&](const std::vector<std::string>& sentences, std::initializer_list<const char*> shown_by) {
    for (const std::string& s : sentences) r.findings.push_back({Finding::Kind::fault, s, section_of(r, shown_by)});
  };
  add(assembly_sentences(a, p), {"displacement", "every-instant"});
  add(singularity_sentences(a), {"singularity", "mobility", "every-instant"});
  add(nearness_sentences(a), {"singularity", "every-instant"});
  add(jump_sentences(a), {"velocity", "displacement", "every-instant"});
  add(unseen_sentences(a, unseen), {"every-instant"});
  add(range_sentences(a, p), {"displacement", "every-instant"});
  add(limit_sentences(a), {"dynamics", "drives", "reactions", "speed"});
  add(remark_sentences(a), {"mechanism", "mobility"});
}

// The first page holds a dozen faults, and the number of those beyond.
void limit_faults(std::vector<Finding>& findings) {
  constexpr std::ptrdiff_t most = 12;
  const auto faults = std::ranges::count(findings, Finding::Kind::fault, &Finding::kind);
  if (faults <= most) return;
  findings.erase(findings.begin() + most, findings.begin() + faults);
  findings.insert(findings.begin() + most,
                  {Finding::Kind::fault, fmt::format("{} more in the sections.", plural(static_cast<int>(faults - most), "warning"))});
}

// What is proved of the motion, and what of it is not, but for what a fault tells.
void add_proof(Report& r, const Proved& p) {
  const bool all = p.proof.unexamined.empty() && std::ranges::all_of(p.proof.claims, [](const ProvedClaim& c) {
                     return c.state == ProvedClaim::State::holds || c.state == ProvedClaim::State::broken;
                   });
  if (std::string sentence = remaining_sentence(p); !sentence.empty())
    r.findings.push_back({all ? Finding::Kind::result : Finding::Kind::surprise, std::move(sentence), section_of(r, {"every-instant"})});
}

// What is told of a motion that ends before it was to.
void tell_ending(Report& r, const Analysis& a) {
  const scenario::MotionRequest& motion = *a.scenario().motion;
  const std::string& ending = a.trajectory().ending;
  if (motion.until_singularity && !ending.empty() && a.trajectory().reaches(a.samples() - 1))
    r.findings.push_back(
        {Finding::Kind::surprise,
         fmt::format("The motion lasts to t = {}, not to the {} asked for, as the scenario allows: it {}. All that is told "
                     "and checked is of this part.",
                     show_time(a, a.samples() - 1), show(motion.end, "s"), ending),
         section_of(r, {"singularity", "every-instant"})});
}

std::string joined(std::string lines) {
  for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos;) lines.replace(at, 1, at + 1 < lines.size() ? "; " : "");
  return lines;
}

std::vector<Paragraph> summary(const Analysis& a) {
  std::vector<Paragraph> out;
  const auto tell = [&](const std::string& text) { out.push_back({Paragraph::Tone::plain, text}); };
  if (!a.scenario().motion) {
    tell(fmt::format("No motion is prescribed; {} degrees of freedom.", a.machine().dof()));
    return out;
  }
  const scenario::MotionRequest& motion = *a.scenario().motion;
  for (const std::string& s : acceleration_sentences(a)) out.push_back({Paragraph::Tone::note, s});
  tell(fmt::format("{} over {}, {} degrees of freedom.", plural(a.samples(), "sample"), show_time(a, a.samples() - 1), a.machine().dof()));
  tell(fmt::format("Motion: {}.", joined(motion.description)));
  tell(fmt::format("Load on the platform: {}.", joined(a.scenario().load.description)));
  return out;
}

// What the numbers rest on and no section can show, as far as this run depends on it.
std::vector<std::string> assumptions(const Analysis& a, const Report& r) {
  std::vector<std::string> out;
  const auto has = [&](const char* kind) { return !section_of(r, {kind}).empty(); };
  const bool forces = a.has_dynamics() || has("statics");
  out.push_back(has("stiffness")
                    ? "Bodies are rigid, but for section stiffness, where the declared elements give way a little about the rigid pose."
                    : "Bodies are rigid and keep their declared sizes.");
  if (forces || has("reactions"))
    out.push_back(has("drives") ? "Joints have neither clearance nor friction; what the drives lose is as [drive] says."
                                : "Joints have neither clearance nor friction, and drives none.");
  if (forces) {
    const auto any = [](const std::vector<Eigen::Vector3d>& all) {
      return std::ranges::any_of(all, [](const auto& v) { return !v.isZero(0); });
    };
    if (any(a.scenario().load.force) || any(a.scenario().load.moment))
      out.push_back("The load acts at the platform's reference point, in the axes of the base.");
    if (a.scenario().load.gravity.isZero()) out.push_back("No gravity is given: all bodies are weightless.");
  }
  // Passive joints that turn; a slide is bounded by its drive, or by the joints beside it.
  int silent = 0, limited = 0;
  const Topology& t = a.machine().topology();
  for (std::size_t i = 0; i < t.joints.size(); ++i) {
    const Joint& j = t.joints[i];
    const bool driven = std::ranges::any_of(t.actuators, [&](const Actuator& x) { return x.joint == static_cast<int>(i); });
    if (j.kind == JointKind::prismatic || driven) continue;
    const bool any = std::ranges::any_of(j.limits, [](const Range& range) { return std::isfinite(range.min) || std::isfinite(range.max); });
    ++(any ? limited : silent);
  }
  if (silent > 0 && (a.samples() > 0 || has("workspace")))
    out.push_back(limited == 0 ? "No passive joint declares how far it turns: all turn freely."
                               : fmt::format("{} of {} passive joints declare no limit and turn freely.", silent, silent + limited));
  return out;
}

}  // namespace

void put_front(Report& r, const Analysis& a, const Proved& p, const std::vector<analysis::Unseen>& unseen,
               std::vector<Finding> of_sections) {
  add_faults(r, a, p, unseen);
  if (a.scenario().motion) {
    tell_ending(r, a);
    add_proof(r, p);
  }
  for (Finding& f : surprises(a, r)) of_sections.push_back(std::move(f));
  r.findings.insert(r.findings.end(), of_sections.begin(), of_sections.end());
  std::ranges::stable_sort(r.findings, {}, &Finding::kind);
  limit_faults(r.findings);
  r.key_numbers = key_numbers(a, r);
  r.summary = summary(a);
  r.assumptions = assumptions(a, r);
  for (const char* kind : {"statics", "dynamics", "reactions", "stiffness", "transmission", "singularity", "workspace"})
    if (section_of(r, {kind}).empty()) r.not_asked.emplace_back(kind);
}

}  // namespace pmreport::section
