// Sections `displacement`, `velocity`, `acceleration`, and the overview.
#include <reports/section/common/plots.hpp>
#include <reports/section/common/words.hpp>
#include <reports/section/displacement/prescribed.hpp>
#include <reports/section/section.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::section {

using document::Paragraph;
using document::Section;
using mechanics::Column;

namespace {

void add_panel(figure::Figure& f, const Analysis& a, const std::string& title, const std::string& axis, const std::string& unit,
               const std::vector<Trace>& curves) {
  if (!curves.empty()) f.panels.push_back(panel(a, title, axis, unit, curves));
}

bool linear_drives(const Analysis& a) { return a.machine().topology().actuators.front().unit == "m"; }

std::vector<Column> columns_in(const Analysis& a, const std::string& section, std::initializer_list<std::string_view> groups) {
  std::vector<Column> out;
  for (const Column& c : mechanics::columns_of(section, a.machine().topology()))
    if (std::find(groups.begin(), groups.end(), c.group) != groups.end()) out.push_back(c);
  return out;
}

void add_actuators(figure::Figure& f, const Analysis& a, const std::string& section, const std::string& suffix, const std::string& words,
                   const std::string& per) {
  for (const std::string unit : {"m", "rad"}) add_panel(f, a, words, words, unit + per, group(a, section, "actuator" + suffix, unit + per));
}

// Joint motions: in one panel as long as they are few, else those of one letter in one: A1 A2 ..., B1 B2 ...
void add_joints(figure::Figure& f, const Analysis& a) {
  constexpr std::size_t few = 10;
  const std::vector<Trace> all = group(a, "displacement", "joint_angle");
  if (all.size() <= few) return add_panel(f, a, "joints", "motion from home", "rad", all);
  std::vector<std::pair<std::string, std::vector<Trace>>> kinds;
  for (const Trace& c : all) {
    const std::string letters = c.column.substr(0, c.column.find_first_of("0123456789_"));
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == letters; });
    (found != kinds.end() ? *found : kinds.emplace_back(letters, std::vector<Trace>{})).second.push_back(c);
  }
  for (const auto& [letters, curves] : kinds) add_panel(f, a, "joints " + letters, "motion from home", "rad", curves);
}

// The matrices that the source states, at the first sample that has a pose.
void add_matrices(Section& s, const Analysis& a) {
  const Topology& t = a.machine().topology();
  if (t.matrices.empty()) return;
  int sample = 0;
  while (sample < a.samples() && a.outcome(sample) != Outcome::good) ++sample;
  if (sample == a.samples()) return;
  const Eigen::VectorXd q = a.trajectory().value.row(sample);
  const std::vector<Eigen::MatrixXd> all = a.machine().matrices({q.data(), static_cast<std::size_t>(q.size())}, a.pose(sample));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const SourceMatrix& m = t.matrices[i];
    std::vector<std::string> of;
    if (m.acts_on == Rates::coordinates)
      for (const Coordinate& c : t.coordinates) of.push_back(symbol(c.name));
    else if (m.acts_on == Rates::actuators)
      for (const Actuator& x : t.actuators) of.push_back(symbol(x.name));
    else
      of = {"vx", "vy", "vz", "ωx", "ωy", "ωz"};
    document::Table table{fmt::format("Matrix {}, {}, at t = {}; SI units.", m.name, m.title, show_time(a, sample)),
                          of,
                          std::vector<bool>(of.size(), true),
                          {}};
    for (Eigen::Index r = 0; r < all[i].rows(); ++r) {
      std::vector<std::string> row;
      for (Eigen::Index c = 0; c < all[i].cols(); ++c) row.push_back(typeset(format_number(all[i](r, c), 5)));
      table.rows.push_back(std::move(row));
    }
    s.blocks.push_back(std::move(table));
  }
}

}  // namespace

Section displacement_section(const Analysis& a) {
  Section s{"displacement", "displacement", "Displacement", {}};
  for (const std::string& line : reach_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  for (const LimitBreach& b : a.breaches()) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, sentence(a, b)});

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
                   "Pose of the platform, actuators, and joint motions from home, against time.",
                   "data/displacement.csv",
                   figure::Width::full,
                   2,
                   {}};
  add_panel(f, a, "position", "position", "m", group(a, "displacement", "coordinate", "m"));
  add_panel(f, a, "orientation", "angle", "rad", group(a, "displacement", "coordinate", "rad"));
  add_actuators(f, a, "displacement", "", linear_drives(a) ? "actuator length" : "actuator value", "");
  for (const std::string name : {"derived", "reading"})
    for (const std::string unit : {"m", "rad", "1"})
      add_panel(f, a, name == "derived" ? "derived quantities" : "quantities of the source",
                unit == "m"     ? "length"
                : unit == "rad" ? "angle"
                                : "value",
                unit == "1" ? "" : unit, group(a, "displacement", name, unit));
  add_joints(f, a);
  s.blocks.push_back(f);
  s.blocks.push_back(extremes(a, "Extremes over the motion.",
                              columns_in(a, "displacement", {"coordinate", "derived", "actuator", "reading", "joint_angle"})));
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
  return s;
}

Section velocity_section(const Analysis& a) {
  Section s{"velocity", "velocity", "Velocity", {}};
  for (const std::string& line : singularity_sentences(a)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, line});
  s.blocks.push_back(Paragraph{
      Paragraph::Tone::plain,
      fmt::format(
          "Rates are exact derivatives of the geometry. G is the overall Jacobian, G·(v; ω) = (actuator rates; 0), for the twist of the "
          "platform's reference point in base axes; its condition number takes moments per characteristic length {}.",
          show(a.length(), "m"))});
  figure::Figure f{"velocity",
                   "Rates of the actuators, twist of the platform, and condition of the overall Jacobian.",
                   "data/velocity.csv",
                   figure::Width::full,
                   2,
                   {}};
  add_actuators(f, a, "velocity", "_rate", "actuator rate", "/s");
  add_panel(f, a, "velocity of the platform", "velocity", "m/s", group(a, "velocity", "velocity"));
  add_panel(f, a, "angular velocity of the platform", "angular velocity", "rad/s", group(a, "velocity", "angular_velocity"));
  add_panel(f, a, "condition number of G", "condition number", "", {{"condition", ""}});
  s.blocks.push_back(f);
  s.blocks.push_back(extremes(a, "Extremes over the motion.",
                              columns_in(a, "velocity", {"actuator_rate", "velocity", "angular_velocity", "det_G", "condition"})));
  add_matrices(s, a);
  std::vector<Claim> claims{
      {Measure::velocity, "Relative velocities are those the joints allow",
       "twists of all bodies in the constraints of the generic model, relative to the largest twist", 1e-9, ""},
      {Measure::jacobian, "Closed form equals the geometry", "G times twist against actuator rates by differentiation, relative", 1e-9, ""},
      {Measure::forward_velocity, "Forward velocity returns the twist", "twist solved from the actuator rates, relative", 1e-7, ""},
      {Measure::difference_rate, "Derivatives are exact",
       "rates of every body and joint against eighth-order differences in extended precision, relative", 1e-11, ""}};
  if (!a.machine().topology().matrices.empty())
    claims.push_back(
        {Measure::source, "The source's matrices hold", "its relations with the rates by differentiation, relative", 1e-9, ""});
  s.blocks.push_back(proof(a, claims));
  return s;
}

Section acceleration_section(const Analysis& a) {
  Section s{"acceleration", "acceleration", "Acceleration", {}};
  figure::Figure f{
      "acceleration", "Accelerations of the actuators and of the platform.", "data/acceleration.csv", figure::Width::full, 2, {}};
  add_actuators(f, a, "acceleration", "_acceleration", "actuator acceleration", "/s^2");
  add_panel(f, a, "acceleration of the platform", "acceleration", "m/s^2", group(a, "acceleration", "acceleration"));
  add_panel(f, a, "angular acceleration of the platform", "angular acceleration", "rad/s^2",
            group(a, "acceleration", "angular_acceleration"));
  s.blocks.push_back(f);
  s.blocks.push_back(extremes(a, "Extremes over the motion.",
                              columns_in(a, "acceleration", {"actuator_acceleration", "acceleration", "angular_acceleration"})));
  s.blocks.push_back(
      proof(a, {{Measure::acceleration, "Relative accelerations are those the joints allow",
                 "accelerations of all bodies in the differentiated constraints of the generic model, relative", 1e-9, ""},
                {Measure::jacobian_rate, "Closed form equals the geometry",
                 "G times twist rate plus dG/dt times twist, against actuator accelerations by differentiation, relative", 1e-9, ""},
                {Measure::forward_acceleration, "Forward acceleration returns the twist rate",
                 "solved from the actuator accelerations, relative", 1e-7, ""},
                {Measure::difference_acceleration, "Second derivatives are exact",
                 "accelerations of every body and joint against eighth-order differences in extended precision, relative", 1e-9, ""}}));
  return s;
}

std::vector<Section> overview_section(const Analysis& a) {
  figure::Figure f{"overview", "", "", figure::Width::full, 2, {}};
  std::vector<std::string> shown;
  const auto asked = [&](const char* kind) { return a.scenario().asks_for(kind); };
  const auto add_forces = [&](const char* section, const char* group_name, bool constraints, const std::string& words) {
    for (const std::string unit : {"N", "N*m"}) {
      std::vector<Trace> forces = group(a, section, group_name, unit);
      if (constraints)
        for (const Trace& c : group(a, section, "constraint", unit)) forces.push_back(c);
      const std::string kind = unit == "N" ? "force" : "moment";
      add_panel(f, a, kind + "s" + words, kind, unit, forces);
    }
  };
  const std::string value = linear_drives(a) ? "length" : "value";
  if (asked("displacement")) {
    shown.push_back("position and orientation of the platform, displacement of the actuators");
    add_panel(f, a, "position", "position", "m", group(a, "displacement", "coordinate", "m"));
    add_panel(f, a, "orientation", "angle", "rad", group(a, "displacement", "coordinate", "rad"));
    add_actuators(f, a, "displacement", "", "actuator " + value, "");
  }
  if (asked("velocity")) shown.push_back("their rates"), add_actuators(f, a, "velocity", "_rate", "actuator rate", "/s");
  if (asked("acceleration"))
    shown.push_back("their accelerations"), add_actuators(f, a, "acceleration", "_acceleration", "actuator acceleration", "/s^2");
  const bool statics = asked("statics"), dynamics = asked("dynamics");
  if (statics)
    shown.push_back("actuator forces and constraint wrenches at rest"),
        add_forces("statics", "actuator_force", true, dynamics ? " at rest" : "");
  if (dynamics) shown.push_back("actuator forces in motion"), add_forces("dynamics", "dynamic_force", false, " in motion");
  if (shown.size() < 3) return {};
  f.caption = fmt::format("The motion at a glance: {}.", fmt::join(shown, "; "));
  return {Section{"overview", "overview", "Overview", {f}}};
}

}  // namespace pmreport::section
