// What the kinds of joints are called: the one table of it.
#pragma once

#include <pmreport/topology.hpp>
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

}  // namespace pmreport::mechanics
