// Parts as parameters describe them: limits of joints and drives, inertias of the usual bodies.
#pragma once

#include <pmreport/parameter.hpp>

#include <string>

namespace pmreport {

// Limits of a joint: as far either way from home (hinge, universal joint, slide), or up to (the cone of a ball).
constexpr Range either_way(double most) { return {-most, most}; }
constexpr Range up_to(double most) { return {0, most}; }

// From one parameter to another, say from "stroke_min" to "stroke_max". Refuses values that leave nothing between them.
inline Range range_of(const Parameters& p, const std::string& least, const std::string& most) {
  if (p[least] >= p[most]) refuse(least, " must be less than ", most);
  return {p[least], p[most]};
}

// A body of revolution about its z axis, its centre of mass at height `z` [m], from the parameters OF_mass, OF_inertia (transverse, about
// the centre of mass) and OF_axial_inertia.
inline Inertia axisymmetric(const Parameters& p, const std::string& of, double z) {
  return Inertia::axisymmetric(p[of + "_mass"], z, p[of + "_inertia"], p[of + "_axial_inertia"]);
}

// A uniform solid cylinder along its z axis from height `low` to `high` [m], from the parameters OF_mass and OF_radius.
inline Inertia solid_cylinder(const Parameters& p, const std::string& of, double low, double high) {
  return Inertia::solid_cylinder(p[of + "_mass"], high - low, p[of + "_radius"], (low + high) / 2);
}

}  // namespace pmreport
