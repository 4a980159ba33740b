// What the kinds of joints are called, the one table of it, and what their motions count from.
#pragma once

#include <pmreport/topology.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

inline const char* word_of(JointKind k) {
  switch (k) {
    case JointKind::revolute:
      return "revolute";
    case JointKind::prismatic:
      return "prismatic";
    case JointKind::universal:
      return "universal";
    case JointKind::spherical:
      return "spherical";
    case JointKind::cylindrical:
      return "cylindrical";
  }
  return "";
}

// R, P, U, S, C: the field's letters are the initials of the words.
inline char letter_of(JointKind k) { return static_cast<char>(word_of(k)[0] - 'a' + 'A'); }

// "revolute R"
inline std::string word_and_letter(JointKind k) { return std::string(word_of(k)) + ' ' + letter_of(k); }

// What the motion of a joint counts from: "home", or the direction in its socket that a ball declares, "axis z of platform".
inline std::string origin_of(const Topology& t, const Joint& j) {
  if (j.from.isZero()) return "home";
  const std::string& socket = t.bodies[static_cast<std::size_t>(j.stud == j.a ? j.b : j.a)].name;
  for (int k = 0; k < 3; ++k)
    if (j.from == j.from(k) * Eigen::Vector3d::Unit(k))
      return std::string("axis ") + (j.from(k) < 0 ? "-" : "") + "xyz"[k] + " of " + socket;
  return "a direction in " + socket;
}

// "A1_deflection", "B2_angle1", "P6_travel": the motion of a joint that limit `limit` of it bounds, in columns and limits.
inline std::string motion_name(const Joint& j, std::size_t limit) {
  if (j.kind == JointKind::spherical) return j.name + "_deflection";
  if (j.kind == JointKind::prismatic) return j.name + "_travel";
  return j.name + "_angle" + (j.limits.size() > 1 ? std::to_string(limit + 1) : "");
}

// Of all joints: "home", "home; those of B1, B2 from axis z of platform".
inline std::string origins_of(const Topology& t) {
  std::vector<std::pair<std::string, std::string>> declared;  // origin, joints; in the order of the joints
  for (const Joint& j : t.joints) {
    if (j.from.isZero()) continue;
    const std::string origin = origin_of(t, j);
    const auto known = std::find_if(declared.begin(), declared.end(), [&](const auto& d) { return d.first == origin; });
    if (known == declared.end())
      declared.emplace_back(origin, j.name);
    else
      known->second += ", " + j.name;
  }
  std::string out = "home";
  for (const auto& [origin, names] : declared) out += "; those of " + names + " from " + origin;
  return out;
}

}  // namespace pmreport::mechanics
