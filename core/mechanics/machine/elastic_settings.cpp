#include <core/mechanics/machine/elastic_settings.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

namespace {

bool is_joint(const Topology& t, int joint) { return joint >= 0 && joint < static_cast<int>(t.joints.size()); }

bool named_well(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && letter(name.front()) &&
         std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

int body_across(const Joint& j, int body) { return j.a == body ? j.b : j.b == body ? j.a : -1; }

}  // namespace

std::vector<Element> elements_under(const ElasticSettings& settings, const Topology& declared) {
  std::vector<Element> out = declared.elements;
  for (Element& e : out) {
    if (settings.material && (e.kind == ElementKind::beam || e.kind == ElementKind::rail)) e.material = *settings.material;
  }
  for (std::size_t i = 0; i < settings.drives.size(); ++i) {
    if (std::isnan(settings.drives[i])) continue;
    bool found = false;
    for (Element& e : out)
      if (e.kind == ElementKind::drive && e.actuator == static_cast<int>(i)) e.stiffness[0] = settings.drives[i], found = true;
    if (found) continue;
    Element drive;
    drive.name = "drive_" + declared.actuators[i].name;
    drive.kind = ElementKind::drive;
    drive.actuator = static_cast<int>(i);
    drive.stiffness[0] = settings.drives[i];
    out.push_back(drive);
  }
  for (const Element& e : settings.added) {
    const auto same = std::ranges::find(out, e.name, &Element::name);
    if (same != out.end())
      *same = e;
    else
      out.push_back(e);
  }
  if (settings.bends)
    for (Element& e : out) e.bends = *settings.bends;
  std::erase_if(out, [&](const Element& e) {
    return std::ranges::find(settings.rigid, e.name) != settings.rigid.end() ||
           std::ranges::find(settings.rigid_kinds, e.kind) != settings.rigid_kinds.end();
  });
  return out;
}

// Breadth first: the shortest chain, the earlier joint of two.
BeamPath path_of(const Topology& t, int from, int to) {
  struct Step {
    int joint, body, before;  // reached by `body`, from the step `before`
  };
  std::vector<Step> steps{{from, -1, -1}};
  std::vector<bool> seen(t.joints.size(), false);
  seen[static_cast<std::size_t>(from)] = true;
  for (std::size_t at = 0; at < steps.size() && steps.back().joint != to; ++at) {
    const Joint& here = t.joints[static_cast<std::size_t>(steps[at].joint)];
    for (const int body : {here.a, here.b}) {
      if (body == 0 || body == t.platform || body == steps[at].body) continue;
      for (std::size_t j = 0; j < t.joints.size() && steps.back().joint != to; ++j) {
        if (seen[j] || body_across(t.joints[j], body) < 0) continue;
        seen[j] = true;
        steps.push_back({static_cast<int>(j), body, static_cast<int>(at)});
      }
    }
  }
  BeamPath out;
  if (from == to || steps.back().joint != to) return out;
  for (int at = static_cast<int>(steps.size()) - 1; at >= 0; at = steps[static_cast<std::size_t>(at)].before) {
    const Step& s = steps[static_cast<std::size_t>(at)];
    out.joints.insert(out.joints.begin(), s.joint);
    if (s.body >= 0) out.bodies.insert(out.bodies.begin(), s.body);
  }
  return out;
}

std::string fault_of(const Element& e, const Topology& t) {
  // Columns beam_axial, element_share are groups.
  for (const char* kind : {"beams", "rails", "drives", "bearings"})
    if (e.name == kind) return fmt::format("an element cannot be called {}, which names all of a kind", e.name);
  if (e.name == "beam" || e.name == "element") return fmt::format("an element cannot be called {}, which names the columns of all", e.name);
  if (!named_well(e.name))
    return fmt::format("expected a name of letters, digits and underscores that begins with a letter, seen \"{}\"", e.name);
  const auto fault = [&](const std::string& what) { return fmt::format("element {}: {}", e.name, what); };
  const auto above_zero = [&](double x, const char* what, const char* unit) {
    return x > 0 ? std::string()
                 : fault(fmt::format("expected {} above zero, seen {} {}; leave the element out to have it rigid", what, x, unit));
  };
  std::string out;
  const auto demand = [&out](const std::string& next) {
    if (out.empty()) out = next;
  };
  const auto demand_joint = [&](int joint) {
    if (!is_joint(t, joint)) demand(fault(fmt::format("joint {} does not exist", joint)));
  };
  switch (e.kind) {
    case ElementKind::beam: {
      demand_joint(e.from), demand_joint(e.to);
      if (!out.empty()) return out;
      const Joint &a = t.joints[static_cast<std::size_t>(e.from)], &b = t.joints[static_cast<std::size_t>(e.to)];
      const BeamPath path = path_of(t, e.from, e.to);
      if (path.bodies.empty())
        demand(fault(fmt::format("no bodies lead from joint {} to joint {} without base and platform", a.name, b.name)));
      else if (e.section.bending[0] != e.section.bending[1] && t.bodies[static_cast<std::size_t>(path.bodies.front())].slender)
        demand(fault("its body may spin about itself, and has no direction for two different second moments"));
      if (e.beside != -1) {
        const int last = path.bodies.empty() ? -1 : path.bodies.back();
        if (!is_joint(t, e.beside) || e.beside == e.to || body_across(t.joints[static_cast<std::size_t>(e.beside)], last) < 0)
          demand(fault(fmt::format("joint {} is none beside joint {} on its last body", e.beside, b.name)));
      }
      demand(above_zero(e.material.modulus, "a modulus", "Pa"));
      demand(above_zero(e.material.shear_modulus, "a shear modulus", "Pa"));
      demand(above_zero(e.section.area, "an area", "m^2"));
      for (const double x : {e.section.bending[0], e.section.bending[1], e.section.torsion})
        demand(above_zero(x, "second moments of area", "m^4"));
      if (!(e.buckling_length >= 0 && std::isfinite(e.buckling_length))) demand(fault("its buckling length is no number from zero up"));
      if (static_cast<int>(e.bends) < 0 || static_cast<int>(e.bends) > PM_BENDING_FULL) demand(fault("bends in an unknown way"));
      break;
    }
    case ElementKind::rail: {
      demand_joint(e.from), demand_joint(e.to);
      if (!out.empty()) return out;
      if (std::ranges::none_of(t.actuators, [&](const Actuator& a) { return a.joint == e.from && a.sense() == Sense::linear; }))
        demand(fault(fmt::format("joint {} is no slide with an actuator, and a rail lies along one",
                                 t.joints[static_cast<std::size_t>(e.from)].name)));
      demand(above_zero(e.material.modulus, "a modulus", "Pa"));
      demand(above_zero(e.section.area, "an area", "m^2"));
      if (!(e.offset >= 0 && std::isfinite(e.offset))) demand(fault(fmt::format("expected an offset from zero up, seen {} m", e.offset)));
      break;
    }
    case ElementKind::drive:
      if (e.actuator < 0 || e.actuator >= static_cast<int>(t.actuators.size()))
        return fault(fmt::format("actuator {} does not exist", e.actuator));
      demand(above_zero(e.stiffness[0], "a stiffness", ""));
      break;
    case ElementKind::bearing:
      demand_joint(e.to);
      for (const double x : e.stiffness) demand(above_zero(x, "a stiffness", ""));
      break;
    default:
      return fault(fmt::format("is of unknown kind {}", static_cast<int>(e.kind)));
  }
  if (!std::isfinite(e.material.expansion)) demand(fault("its expansion is no finite number"));
  return out;
}

}  // namespace pmreport::mechanics
