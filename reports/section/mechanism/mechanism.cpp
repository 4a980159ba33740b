// Section `mechanism`: what it is, its parameters, joints and bodies, and its mobility by count and by rank.
#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/mobility/mobility_count.hpp>
#include <reports/section/common/inputs.hpp>
#include <reports/section/common/words/remarks.hpp>
#include <reports/section/common/words/words.hpp>
#include <reports/section/mechanism/mechanism.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using document::Paragraph;
using document::Table;

namespace {

std::string value_of(const mechanics::ParameterInfo& p, const std::vector<double>& value) {
  if (p.kind == PM_CHOICE) return p.choices[static_cast<std::size_t>(value[0])];
  const std::optional<Unit> unit = parse_unit(p.display);
  std::string out;
  for (const double x : value) out += (out.empty() ? "" : ", ") + typeset(format_number(unit ? x / unit->factor : x, 6));
  return out.empty() ? "–" : out;
}

// `inputs` begin with the parameters.
Table parameters(const mechanics::Machine& m, const std::vector<document::Input>& inputs) {
  Table t{"Parameters, each from a line of the scenario or the mechanism's default.",
          {"parameter", "meaning", "value", "unit", "from"},
          {false, false, true, false, false},
          {}};
  for (std::size_t i = 0; i < m.info().parameters.size(); ++i) {
    const mechanics::ParameterInfo& p = m.info().parameters[i];
    const document::Input& in = inputs[i];
    t.rows.push_back({p.name, p.title, value_of(p, m.values()[i]), typographic(p.display),
                      in.line > 0               ? fmt::format("line {}", in.line)
                      : in.source == "scenario" ? in.source
                                                : "default"});
  }
  return t;
}

// What the scenario says besides, as it says it.
Table said(const std::vector<document::Input>& inputs, std::size_t parameters) {
  Table t{"Motion, load, drives and limits as the scenario has them.", {"input", "as written", "line"}, {false, false, true}, {}};
  for (std::size_t i = parameters; i < inputs.size(); ++i)
    t.rows.push_back({inputs[i].name, inputs[i].text, std::to_string(inputs[i].line)});
  return t;
}

Table joints(const mechanics::Machine& m) {
  const Topology& t = m.topology();
  Table table{"Joints. Deflections and rotations count from " + mechanics::origins_of(t) + ".",
              {"joint", "kind", "connects", "with", "freedoms", "from", "to"},
              {false, false, false, false, true, true, true},
              {}};
  const auto body = [&](int i) { return t.bodies[static_cast<std::size_t>(i)].name; };
  for (const Joint& j : t.joints) {
    const Actuator* drive = nullptr;
    for (const Actuator& a : t.actuators)
      if (t.joints[static_cast<std::size_t>(a.joint)].name == j.name) drive = &a;
    std::string from, to;
    if (drive != nullptr) {
      from = show(drive->stroke.min, drive->unit), to = show(drive->stroke.max, drive->unit);
    } else {
      for (const Range& r : j.limits) {
        const char* unit = j.kind == JointKind::prismatic ? "m" : "rad";
        from += (from.empty() ? "" : ", ") + show(r.min, unit);
        to += (to.empty() ? "" : ", ") + show(r.max, unit);
      }
    }
    table.rows.push_back({j.name, mechanics::word_and_letter(j.kind) + (drive != nullptr ? ", drives " + drive->name : ""), body(j.a),
                          body(j.b), std::to_string(freedoms_of(j.kind)), from, to});
  }
  return table;
}

Table bodies(const mechanics::Machine& m) {
  Table table{"Bodies. Centre of mass from the body's origin, inertia about it, in body axes.",
              {"body", "limb", "mass [kg]", "centre of mass [mm]", "Ixx, Iyy, Izz [kg·m²]"},
              {false, true, true, true, true},
              {}};
  const Topology& t = m.topology();
  for (std::size_t i = 1; i < t.bodies.size(); ++i) {
    const Body& b = t.bodies[i];
    const Eigen::Vector3d c = b.inertia.centre * 1e3, d = b.inertia.about_centre.diagonal();
    table.rows.push_back({b.name, b.limb > 0 ? std::to_string(b.limb) : "–", format_number(b.inertia.mass, 4),
                          typeset(fmt::format("({}, {}, {})", format_number(c.x(), 4), format_number(c.y(), 4), format_number(c.z(), 4))),
                          typeset(fmt::format("{}, {}, {}", format_number(d.x(), 4), format_number(d.y(), 4), format_number(d.z(), 4)))});
  }
  return table;
}

Table mobility(const mechanics::Mobility& m, int idle) {
  return {"Mobility, by count and by rank of the constraints of the generic model at home.",
          {"quantity", "value"},
          {false, true},
          {{"links n, base included", std::to_string(m.bodies)},
           {"joints g", std::to_string(m.joints)},
           {"sum of joint freedoms Σf", std::to_string(m.freedoms_sum)},
           {"idle freedoms ζ, declared", std::to_string(idle)},
           {"Grübler–Kutzbach 6(n − g − 1) + Σf − ζ", std::to_string(m.gruebler)},
           {"constraint rows, their rank", fmt::format("{}, {}", m.rows, m.rank)},
           {"redundant constraints, by rank", std::to_string(m.redundant)},
           {"idle freedoms, by rank", std::to_string(m.idle)},
           {"degrees of freedom, by rank", std::to_string(m.freedoms)}}};
}

}  // namespace

Result mechanism_section(const Analysis& a, const Stage& stage) {
  const mechanics::Machine& m = a.machine();
  const mechanics::Mobility& mob = a.mobility();
  document::Section s{"mechanism", "mechanism", "Mechanism", {}};
  Stage::Ordered portrait = stage.portrait("mechanism");
  s.blocks.push_back(Paragraph{Paragraph::Tone::plain, m.info().title + ". Source: " + m.info().source + "."});
  document::Picture diagram = stage.diagram("diagram");
  s.blocks.push_back(document::Gallery{{portrait.wait()}, ""});
  s.blocks.push_back(document::Gallery{{std::move(diagram)}, ""});
  const std::vector<document::Input> inputs = inputs_of(a);
  s.blocks.push_back(parameters(m, inputs));
  if (Table t = said(inputs, m.info().parameters.size()); !t.rows.empty()) s.blocks.push_back(std::move(t));
  s.blocks.push_back(joints(m));
  s.blocks.push_back(bodies(m));
  for (const std::string& text : remark_sentences(m)) s.blocks.push_back(Paragraph{Paragraph::Tone::warning, text});
  s.blocks.push_back(mobility(mob, m.topology().idle));
  document::Proof p;
  p.lines.push_back({"Mobility is as declared", fmt::format("degrees of freedom by rank at home against {} declared", m.dof()),
                     std::abs(double(mob.freedoms - m.dof())), 0, ""});
  p.lines.push_back({"Idle freedoms are as declared", fmt::format("spins found by rank against {} declared", m.topology().idle),
                     std::abs(double(mob.idle - m.topology().idle)), 0, ""});
  p.lines.push_back({"The count agrees with the rank", "Grübler–Kutzbach with the redundant constraints that the rank shows",
                     std::abs(double(mob.gruebler + mob.redundant - mob.freedoms)), 0, ""});
  s.blocks.push_back(p);
  return {s};
}

}  // namespace pmreport::section
