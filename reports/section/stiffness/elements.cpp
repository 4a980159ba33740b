// What gives way: the table of elements, and what is left rigid.
#include <reports/section/common/words/words.hpp>
#include <reports/section/stiffness/stiffness.hpp>

#include <core/mechanics/machine/limb_line.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace pmreport::section {

namespace {

std::string stiffness_words(double k, const char* unit) { return std::isinf(k) ? "rigid" : show(k, unit, 3); }

// "E 210 GPa, G 81 GPa, A 942 mm²"
std::string make_words(const Element& e) {
  const auto modulus = [](double x) { return show(x, "Pa", 3); };
  std::string out = fmt::format("E {}, ", modulus(e.material.modulus));
  if (e.kind == ElementKind::beam) out += fmt::format("G {}, ", modulus(e.material.shear_modulus));
  out += fmt::format("A {} mm²", typeset(format_number(e.section.area * 1e6, 3)));
  if (e.kind != ElementKind::beam) return out;
  const auto fourth = [](double x) { return typeset(format_number(x * 1e12, 3)) + " mm⁴"; };
  out += e.section.bending[0] == e.section.bending[1]
             ? ", I " + fourth(e.section.bending[0])
             : fmt::format(", I {} and {}", fourth(e.section.bending[0]), fourth(e.section.bending[1]));
  return out + ", J " + fourth(e.section.torsion);
}

std::string bends_words(Bending bends) {
  return bends == Bending::full ? "" : bends == Bending::couples ? " bent by couples alone," : " not bent,";
}

// What the table says of an element: what it is, its length, and how stiff; `joints`: which are its own. `l`: its length [m].
std::vector<std::string> words_of_element(const Element& e, const Topology& t, double l, std::string& joints) {
  const auto joint = [&](int j) { return t.joints[static_cast<std::size_t>(j)].name; };
  const std::string length = std::isfinite(l) ? show(l, "m") : "";
  const auto turning = [](double k) { return std::isinf(k) ? std::string("rigid") : show(k, "N*m", 3) + "/rad"; };
  switch (e.kind) {
    case ElementKind::beam: {
      const double least = std::min(e.section.bending[0], e.section.bending[1]);
      joints = fmt::format(" {} to {}", joint(e.from), joint(e.to));
      return {"beam" + bends_words(e.bends),
              length,
              stiffness_words(e.material.modulus * e.section.area / l, "N/m"),
              e.bends == Bending::full ? stiffness_words(3 * e.material.modulus * least / (l * l * l), "N/m") : "",
              turning(e.material.shear_modulus * e.section.torsion / l),
              make_words(e)};
    }
    case ElementKind::rail:
      joints = fmt::format(" along {}, loaded by {}", joint(e.from), joint(e.to));
      return {"rail", length, l > 0 ? stiffness_words(e.material.modulus * e.section.area / l, "N/m") : "rigid", "", "", make_words(e)};
    case ElementKind::drive: {
      const Actuator& x = t.actuators[static_cast<std::size_t>(e.actuator)];
      const bool linear = x.sense() == Sense::linear;
      joints = fmt::format(" of {}", symbol(x.name));
      return {"drive", "", linear ? stiffness_words(e.stiffness[0], "N/m") : "", "", linear ? "" : turning(e.stiffness[0]), ""};
    }
    case ElementKind::bearing:
      break;
  }
  joints = " " + joint(e.to);
  return {"joint",
          "",
          stiffness_words(e.stiffness[0], "N/m"),
          stiffness_words(e.stiffness[1], "N/m"),
          turning(e.stiffness[2]),
          std::isinf(e.stiffness[3]) ? "" : "tilting " + turning(e.stiffness[3])};
}

}  // namespace

document::Table element_table(const Analysis& a, const ElasticView& at) {
  const Topology& t = a.machine().topology();
  document::Table out{
      fmt::format("What gives way, at {}. All else is rigid. Of a beam along, k = EA/L; across at its end, 3EI/L³; twisted, "
                  "GJ/L.",
                  at.name),
      {"element", "what it is", "length", "along", "across", "twisted", "made of"},
      {false, false, true, true, true, true, false},
      {}};
  // Elements alike stand in one row: the words of each but its name and joints.
  struct Alike {
    std::vector<std::string> names, words;
    std::string first;
  };
  std::vector<Alike> rows;
  for (std::size_t i = 0; i < t.elements.size(); ++i) {
    const Element& e = t.elements[i];
    const double l = at.pose.known ? at.pose.parts.lengths[i] : std::nan("");
    std::string first;
    std::vector<std::string> words = words_of_element(e, t, l, first);
    const auto same = std::ranges::find(rows, words, &Alike::words);
    if (same != rows.end())
      same->names.push_back(e.name);
    else
      rows.push_back({{e.name}, std::move(words), std::move(first)});
  }
  for (const Alike& row : rows) {
    out.rows.push_back({names_of(row.names), row.words.front() + row.first + (row.names.size() > 1 ? ", and so on" : "")});
    out.rows.back().insert(out.rows.back().end(), row.words.begin() + 1, row.words.end());
  }
  return out;
}

std::vector<std::string> rigid_limbs(const Analysis& a) {
  const Topology& t = a.machine().topology();
  std::set<int> soft;
  const auto of_joint = [&](int j) {
    const Joint& joint = t.joints[static_cast<std::size_t>(j)];
    for (const int body : {joint.a, joint.b}) soft.insert(t.bodies[static_cast<std::size_t>(body)].limb);
  };
  for (const Element& e : t.elements) {
    if (e.kind == ElementKind::drive) of_joint(t.actuators[static_cast<std::size_t>(e.actuator)].joint);
    if (e.to >= 0) of_joint(e.to);
    if (e.kind == ElementKind::beam) of_joint(e.from);
  }
  std::vector<std::string> out;
  for (int limb = 1; limb <= mechanics::limbs_of(t); ++limb)
    if (!soft.contains(limb)) out.push_back(fmt::format("limb {}", limb));
  return out;
}

}  // namespace pmreport::section
