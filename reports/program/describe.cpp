#include <core/mechanics/machine/joint_words.hpp>
#include <core/mechanics/machine/machine.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/text/units.hpp>
#include <reports/program/cli/parameter_words.hpp>
#include <reports/program/commands.hpp>
#include <reports/program/terminal.hpp>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace pmreport::program {

using mechanics::Machine;
using mechanics::ParameterInfo;
using mechanics::word_of, mechanics::word_of_effort;

namespace {

// "force [N]" of a linear actuator, "torque [N*m]" of a rotary one.
std::string effort_of(const Actuator& a) { return fmt::format("{} [{}]", word_of_effort(a.sense()), mechanics::unit_of_effort(a.sense())); }

// "-45 deg to 45 deg, -45 deg to 45 deg", and of a ball with a direction what it counts from.
std::string limits_of(const Joint& j, const Topology& t) {
  std::string out;
  const std::string unit = j.kind == JointKind::prismatic ? "mm" : "deg";
  for (const Range& r : j.limits)
    out += fmt::format("{}{} to {}", out.empty() ? "" : ", ", quantity_in_words(r.min, unit), quantity_in_words(r.max, unit));
  if (!j.from.isZero())
    out += fmt::format(" from ({}, {}, {}) of {}", format_number(j.from.x(), 4), format_number(j.from.y(), 4), format_number(j.from.z(), 4),
                       t.bodies[static_cast<std::size_t>(j.stud == j.a ? j.b : j.a)].name);
  return out;
}

// "beam A1 to B1", "drive of rho1": what a part is, and where.
std::string words_of(const Element& e, const Topology& t) {
  const auto joint = [&](int j) { return t.joints[static_cast<std::size_t>(j)].name; };
  switch (e.kind) {
    case ElementKind::beam:
      return fmt::format("beam {} to {}", joint(e.from), joint(e.to));
    case ElementKind::rail:
      return fmt::format("rail along {}, loaded by {}", joint(e.from), joint(e.to));
    case ElementKind::drive:
      return "drive of " + t.actuators[static_cast<std::size_t>(e.actuator)].name;
    case ElementKind::bearing:
      return "joint " + joint(e.to);
  }
  return "";
}

std::string text_of(const Machine& m) {
  const Topology& t = m.topology();
  std::string out = fmt::format("{}\n{}\nsource: {}\n\nindependent coordinates\n", m.info().name, m.info().title, m.info().source);
  for (const Coordinate& c : t.coordinates)
    out += fmt::format("  {:<8} {:<24} home {:<12} box {} to {}\n", c.name, c.title, quantity_in_words(c.home, display_unit_of(c.unit)),
                       quantity_in_words(c.box.min, display_unit_of(c.unit)), quantity_in_words(c.box.max, display_unit_of(c.unit)));
  for (const Derived& d : t.derived)
    out += fmt::format("  {:<8} {:<24} {}\n", d.name, d.title, d.dependent ? "dependent: follows from the others" : "derived");
  out += "\nactuators\n";
  for (const Actuator& a : t.actuators)
    out += fmt::format("  {:<8} {:<24} stroke {} to {}, gives a {}\n", a.name, a.title,
                       quantity_in_words(a.stroke.min, display_unit_of(a.unit)), quantity_in_words(a.stroke.max, display_unit_of(a.unit)),
                       effort_of(a));
  if (!t.constraints.empty()) out += "\nconstraints: wrenches that hold the platform, beside the actuators\n";
  for (const Constraint& c : t.constraints) out += fmt::format("  {:<12} {} [{}]\n", c.name, c.title, c.unit);
  out += "\nparameters\n";
  for (const ParameterInfo& p : m.info().parameters)
    out += fmt::format("  {:<24} {}\n  {:<24} default {}, {}{}\n", p.name, p.title, "", default_in_words(p), range_in_words(p),
                       p.unless.empty() ? "" : "; not beside " + p.unless);
  out += "\njoints, and their limits from home\n";
  for (const Joint& j : t.joints)
    out += fmt::format("  {:<4} {:<12} {} – {}: {}\n", j.name, word_of(j.kind), t.bodies[static_cast<std::size_t>(j.a)].name,
                       t.bodies[static_cast<std::size_t>(j.b)].name, limits_of(j, t));
  if (!t.elements.empty()) out += "\nparts that give way, for stiffness\n";
  for (const Element& e : t.elements) out += fmt::format("  {:<12} {}\n", e.name, words_of(e, t));
  return out;
}

std::string json_of(const Machine& m) {
  using Json = nlohmann::ordered_json;
  const Topology& t = m.topology();
  Json j{{"schema_version", 1}, {"name", m.info().name}, {"title", m.info().title}, {"source", m.info().source}, {"dof", m.dof()}};
  for (const Coordinate& c : t.coordinates)
    j["coordinates"].push_back(
        {{"name", c.name}, {"title", c.title}, {"unit", c.unit}, {"home", c.home}, {"min", c.box.min}, {"max", c.box.max}});
  j["derived"] = Json::array();
  for (const Derived& d : t.derived)
    j["derived"].push_back({{"name", d.name}, {"title", d.title}, {"unit", d.unit}, {"dependent", d.dependent}});
  for (const Actuator& a : t.actuators)
    j["actuators"].push_back({{"name", a.name},
                              {"title", a.title},
                              {"unit", a.unit},
                              {"effort", word_of_effort(a.sense())},
                              {"effort_unit", mechanics::unit_of_effort(a.sense())},
                              {"joint", t.joints[static_cast<std::size_t>(a.joint)].name},
                              {"stroke_min", a.stroke.min},
                              {"stroke_max", a.stroke.max}});
  j["constraints"] = Json::array();
  for (const Constraint& c : t.constraints) j["constraints"].push_back({{"name", c.name}, {"title", c.title}, {"unit", c.unit}});
  j["parameters"] = Json::array();
  for (const ParameterInfo& p : m.info().parameters) {
    Json o{{"name", p.name}, {"title", p.title}};
    if (p.kind == PM_CHOICE) {
      o["choices"] = p.choices;
      o["default"] = p.choices[static_cast<std::size_t>(p.defaults[0])];
    } else {
      o["unit"] = p.unit;
      o["default"] = p.kind == PM_NUMBER ? Json(p.defaults[0]) : Json(p.defaults);
      o["min"] = p.min;
      o["max"] = p.max;
    }
    if (!p.unless.empty()) o["unless"] = p.unless;
    j["parameters"].push_back(o);
  }
  for (const Body& b : t.bodies) {
    const Eigen::Vector3d& c = b.inertia.centre;
    const Eigen::Matrix3d& i = b.inertia.about_centre;
    j["bodies"].push_back({{"name", b.name},
                           {"limb", b.limb},
                           {"slender", b.slender},
                           {"mass", b.inertia.mass},
                           {"centre_of_mass", {c.x(), c.y(), c.z()}},
                           {"inertia", {{i(0, 0), i(0, 1), i(0, 2)}, {i(1, 0), i(1, 1), i(1, 2)}, {i(2, 0), i(2, 1), i(2, 2)}}}});
  }
  for (std::size_t k = 0; k < t.joints.size(); ++k) {
    const Joint& joint = t.joints[k];
    Json limits = Json::array();
    for (const Range& r : joint.limits) limits.push_back({r.min, r.max});
    Json o{{"name", joint.name},
           {"kind", word_of(joint.kind)},
           {"a", t.bodies[static_cast<std::size_t>(joint.a)].name},
           {"b", t.bodies[static_cast<std::size_t>(joint.b)].name},
           {"limits", limits}};
    if (!joint.from.isZero()) o["from"] = {joint.from.x(), joint.from.y(), joint.from.z()};
    j["joints"].push_back(o);
  }
  j["elements"] = Json::array();
  for (const Element& e : t.elements) j["elements"].push_back({{"name", e.name}, {"what", words_of(e, t)}});
  j["platform"] = t.bodies[static_cast<std::size_t>(t.platform)].name;
  j["idle_freedoms"] = t.idle;
  return j.dump(2) + "\n";
}

}  // namespace

int describe(const Options& options) {
  const host::Catalog catalog(host::search_folders(options.plugin_path));
  for (const pm_mechanism* m : mechanisms_named(catalog, options.names.front())) {
    const Machine machine(*m, default_values(mechanics::describe(*m)));
    put("{}", options.json ? json_of(machine) : text_of(machine));
  }
  return all_well;
}

}  // namespace pmreport::program
