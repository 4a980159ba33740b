// Elastic elements in a line each: what gives way under load. All that is not declared is rigid.
//
//   t.add(beam("leg1", leg.low, leg.high, steel, tube(0.030, 0.020)));      a bar between two joints, as long as it is at the pose
//   t.add(spring_drive("servo1", leg.drive, 20e6));                         a drive, in series with its force [N/m]
//   t.add(rail("rail1", slide, foot, steel, solid(0.030), 0.1));            a screw along a slide, from its motor 0.1 m behind zero
//   t.add(bearing("ball1", leg.high, 80e6, 60e6));                          a joint: along its axis, and across it [N/m]
//
// Materials and sections come from numbers, or from parameters that a scenario sets:
//   Parameter::choice("material", material_names, 0, "material of the legs")      material_of(p, "material")
//   tube_parameters are two lengths, NAME_diameter and NAME_bore                  tube_of(p, "leg")
#pragma once

#include <pmreport/parameter.hpp>
#include <pmreport/topology.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace pmreport {

// -- materials: usual values at room temperature; those of carbon along the fibres of a tube wound mostly lengthwise ---------------------

inline constexpr Material steel{210e9, 80.8e9, 11.7e-6}, stainless{196e9, 75e9, 16.5e-6}, cast_iron{110e9, 44e9, 10.5e-6},
    aluminium{70e9, 26.3e9, 23.4e-6}, titanium{114e9, 43.2e9, 8.6e-6}, brass{103e9, 38.1e9, 19e-6}, carbon{120e9, 10e9, 0.5e-6};
inline constexpr const char* material_names[] = {"steel", "stainless", "cast iron", "aluminium", "titanium", "brass", "carbon"};
inline constexpr Material materials[] = {steel, stainless, cast_iron, aluminium, titanium, brass, carbon};

inline Material material_of(const Parameters& p, const std::string& name) {
  return materials[std::ranges::find(material_names, p.choice(name)) - std::begin(material_names)];
}

// -- sections [m] ----------------------------------------------------------------------------------------------------------------------

// A tube of outer and inner diameter.
constexpr CrossSection tube(double outer, double inner) {
  constexpr double pi = std::numbers::pi;
  const double o = outer * outer, i = inner * inner, second = pi * (o * o - i * i) / 64;
  return {pi * (o - i) / 4, {second, second}, 2 * second};
}
constexpr CrossSection solid(double diameter) { return tube(diameter, 0); }

// A solid rectangle, `x` and `y` long along the axes of the body. Torsion by Roark's formula, good to half a per cent.
constexpr CrossSection rectangle(double x, double y) {
  const double a = std::max(x, y), b = std::min(x, y), ratio = b / a, square = ratio * ratio;
  return {x * y, {x * y * y * y / 12, y * x * x * x / 12}, a * b * b * b * (1.0 / 3 - 0.21 * ratio * (1 - square * square / 12))};
}

// From the parameters OF_diameter and OF_bore; refuses a bore that leaves no wall.
inline CrossSection tube_of(const Parameters& p, const std::string& of) {
  if (p[of + "_bore"] >= p[of + "_diameter"]) refuse(of, "_bore must be less than ", of, "_diameter");
  return tube(p[of + "_diameter"], p[of + "_bore"]);
}

// -- elements --------------------------------------------------------------------------------------------------------------------------

// From the centre of joint `from`, where it is rooted, to that of joint `to`, where it is loaded. `buckling_length`: see plugin.h.
inline Element beam(std::string name, int from, int to, const Material& made_of, const CrossSection& section, double buckling_length = 1) {
  Element e{std::move(name), {}, ElementKind::beam, from, to, -1, -1, made_of, section};
  e.buckling_length = buckling_length;
  return e;
}
// To halfway between the joints `to` and `beside` of one body, as an arm that carries a pair of rods.
inline Element arm_beam(std::string name, int from, int to, int beside, const Material& made_of, const CrossSection& section) {
  Element e = beam(std::move(name), from, to, made_of, section);
  e.beside = beside;
  return e;
}
inline Element rail(std::string name, int slide, int loaded, const Material& made_of, const CrossSection& section, double offset = 0) {
  Element e{std::move(name), {}, ElementKind::rail, slide, loaded, -1, -1, made_of, section};
  e.offset = offset;
  return e;
}
// [N/m], of a rotary actuator [N m/rad].
inline Element spring_drive(std::string name, int actuator, double stiffness) {
  Element e{std::move(name), {}, ElementKind::drive, -1, -1, -1, actuator};
  e.stiffness[0] = stiffness;
  return e;
}
// Along and across the joint's axis [N/m]; against tilting across it, and against turning about it [N m/rad].
inline Element bearing(std::string name, int joint, double axial, double radial, double tilting = Element::rigid,
                       double twisting = Element::rigid) {
  Element e{std::move(name), {}, ElementKind::bearing, -1, joint};
  e.stiffness[0] = axial, e.stiffness[1] = radial, e.stiffness[2] = twisting, e.stiffness[3] = tilting;
  return e;
}

}  // namespace pmreport
