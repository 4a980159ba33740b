// Section `displacement`.
#include <core/mechanics/machine/joint_words.hpp>
#include <reports/figure/layout/offsets.hpp>
#include <reports/section/common/kinematic_plots.hpp>
#include <reports/section/common/words/limits.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/displacement/displacement.hpp>
#include <reports/section/displacement/prescribed.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace pmreport::section {

using document::Paragraph;
using document::Section;

namespace {

// "motion from home", or from the direction that all the balls of a panel declare.
std::string motion_from(const Analysis& a, const std::vector<Trace>& curves) {
  const Topology& t = a.machine().topology();
  std::set<std::string> origins;
  for (const Joint& j : t.joints)
    for (std::size_t k = 0; k < j.limits.size(); ++k)
      for (const Trace& c : curves)
        if (c.column == analysis::joint_column(j, k)) origins.insert(mechanics::origin_of(t, j));
  return origins.size() == 1 ? "motion from " + *origins.begin() : "motion";
}

// Joint motions: in one panel as long as they are few, else those of one letter in one: A1 A2 ..., B1 B2 ...
void add_joints(figure::Figure& f, const Analysis& a) {
  constexpr std::size_t few = 10;
  const std::vector<Trace> slides = group(a, analysis::displacement_columns, "joint_travel");
  if (!slides.empty()) add_panel(f, a, "slides", motion_from(a, slides), "m", slides);
  const std::vector<Trace> all = group(a, analysis::displacement_columns, "joint_angle");
  if (all.size() <= few) return add_panel(f, a, "joints", motion_from(a, all), "rad", all);
  std::vector<std::pair<std::string, std::vector<Trace>>> kinds;
  for (const Trace& c : all) {
    const std::string& name = c.column.name();
    const std::string letters = name.substr(0, name.find_first_of("0123456789_"));
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == letters; });
    (found != kinds.end() ? *found : kinds.emplace_back(letters, std::vector<Trace>{})).second.push_back(c);
  }
  for (const auto& [letters, curves] : kinds) add_panel(f, a, "joints " + letters, motion_from(a, curves), "rad", curves);
}

}  // namespace

Result displacement_section(const Analysis& a) {
  Section s{"displacement", "displacement", "Displacement", {}};
  for (const std::string& line : reach_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  for (const std::string& line : breach_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  if (a.breaches().size() > 1) s.blocks.push_back(breach_table(a));

  const Topology& t = a.machine().topology();
  std::string dependent;
  for (const Derived& d : t.derived)
    if (d.dependent) dependent += fmt::format("{}{} ({})", dependent.empty() ? "" : ", ", symbol(d.name), d.title);
  const bool driven = a.scenario().motion->by_actuators();
  std::string words =
      driven ? fmt::format("The scenario prescribes the {} actuators; the pose of the platform follows by forward displacement from home.",
                           a.machine().dof())
             : fmt::format("The platform follows {} prescribed coordinates; actuator values follow by inverse displacement.",
                           a.machine().dof());
  if (!dependent.empty()) words += fmt::format(" Dependent, from the constraint of the limbs: {}.", dependent);
  s.blocks.push_back(Paragraph{Paragraph::Tone::plain, words});

  figure::Figure f{"displacement",
                   "Pose of the platform, actuators, and joint motions, against time. Joints count from " + mechanics::origins_of(t) + ".",
                   "data/displacement.csv",
                   figure::Width::full,
                   2,
                   {}};
  add_panel(f, a, "position", "position", "m", group(a, analysis::displacement_columns, "coordinate", "m"));
  for (figure::Panel& p : f.panels)
    p = figure::set_off(p, figure::low_share);  // where the origin is, matters less than how the platform moves
  add_panel(f, a, "orientation", "angle", "rad", group(a, analysis::displacement_columns, "coordinate", "rad"));
  add_actuators(f, a, analysis::displacement_columns, OfMotion::value, linear_drives(a) ? "actuator length" : "actuator value", "");
  for (const std::string name : {"derived", "reading"})
    for (const std::string unit : {"m", "rad", "1"})
      add_panel(f, a, name == "derived" ? "derived quantities" : "quantities of the source",
                unit == "m"     ? "length"
                : unit == "rad" ? "angle"
                                : "value",
                unit == "1" ? "" : unit, group(a, analysis::displacement_columns, name, unit));
  add_joints(f, a);
  put(s, std::move(f));
  s.blocks.push_back(extremes(
      a, "Extremes over the motion.",
      columns_in(a, analysis::displacement_columns, {"coordinate", "derived", "actuator", "reading", "joint_angle", "joint_travel"})));
  document::Proof evidence = proof(
      a,
      {{Measure::gap, "The joints close", "largest distance of the two images of a joint centre, each carried along by one of its bodies",
        1e-10 * std::max(1.0, a.length()), "m"},
       {Measure::misalignment, "The joint axes agree", "largest angle between the two images of a joint axis", 1e-9, "rad"},
       {Measure::round_trip, "Forward displacement returns the pose",
        driven ? "Newton from a neighbouring pose to the actuator values, against the coordinates found along the motion"
               : "Newton from a neighbouring pose to the actuator values, against the prescribed coordinates",
        1e-8, ""}});
  for (document::Evidence& e : prescribed_evidence(a)) evidence.lines.push_back(std::move(e));
  s.blocks.push_back(std::move(evidence));
  return {s};
}

}  // namespace pmreport::section
