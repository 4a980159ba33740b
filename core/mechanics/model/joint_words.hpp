// What the kinds of joints are called, the one table of it, and what their motions count from.
#pragma once

#include <pmreport/topology.hpp>

#include <map>
#include <string>

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

// Of all joints: "home", "home; those of B1, B2 from axis z of platform".
inline std::string origins_of(const Topology& t) {
  std::map<std::string, std::string> declared;  // joints by origin
  for (const Joint& j : t.joints)
    if (std::string origin = origin_of(t, j); origin != "home") {
      std::string& names = declared[std::move(origin)];
      names += (names.empty() ? "" : ", ") + j.name;
    }
  std::string out = "home";
  for (const auto& [origin, names] : declared) out += "; those of " + names + " from " + origin;
  return out;
}

}  // namespace pmreport::mechanics
