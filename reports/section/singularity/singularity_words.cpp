#include <reports/section/common/words/words.hpp>
#include <reports/section/singularity/singularity.hpp>

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace pmreport::section {

using mechanics::Singularity;
using mechanics::SingularityType;

std::string type_name(SingularityType t) {
  switch (t) {
    case SingularityType::regular:
      return "regular";
    case SingularityType::inverse:
      return "type 1, inverse";
    case SingularityType::direct:
      return "type 2, direct";
    case SingularityType::both:
      return "type 3, both";
    case SingularityType::constraint:
      return "constraint singularity";
  }
  return "";
}

std::string type_words(SingularityType t) {
  switch (t) {
    case SingularityType::regular:
      return "the constraints of the bodies are regular there";
    case SingularityType::inverse:
      return "type 1, inverse: with the platform locked an actuator still moves";
    case SingularityType::direct:
      return "type 2, direct: with the actuators locked the platform still moves";
    case SingularityType::both:
      return "type 3: platform and actuators each move while the other is locked";
    case SingularityType::constraint:
      return "a constraint singularity: the limbs no longer hold the platform to its degrees of freedom";
  }
  return "";
}

namespace {

// Of a space of twists, axes that a reader knows: what is done with forces through joints is done here with rotations about axes through
// them, for (w; v) is built as (f; m) is.
std::vector<mechanics::NamedWrench> readable_twists(const Topology& t, const Singularity& s, double length) {
  mechanics::ScrewSystem swapped = s.freedoms.escapes;
  swapped.basis.topRows(3) = s.freedoms.escapes.basis.bottomRows(3);
  swapped.basis.bottomRows(3) = s.freedoms.escapes.basis.topRows(3);
  std::vector<int> joints;
  for (int j = 0; j < static_cast<int>(s.state.joints.size()); ++j) joints.push_back(j);
  return readable_basis(swapped, landmarks_of(t, s.state, joints), length);
}

}  // namespace

mechanics::Screw escape_screw(const Topology& t, const ExaminedPose& p, double length) {
  if (p.at.freedoms.platform > 0) return readable_twists(t, p.at, length)[0].screw;
  return mechanics::screw_of_twist(p.at.conditioning.escape, p.at.freedoms.escapes.origin, length);
}

std::string escape_words(const Analysis& a, const ExaminedPose& p, double length) {
  const Surroundings s = surroundings(a.machine(), p.at.state, length);
  if (p.at.freedoms.platform == 0)
    return fmt::format("{}: the twist that the actuators hold least is to {}.", p.name,
                       twist_words(s, escape_screw(a.machine().topology(), p, length)));
  std::vector<std::string> all;
  for (const auto& w : readable_twists(a.machine().topology(), p.at, length)) all.push_back(twist_words(s, w.screw));
  return fmt::format("{}: with all actuators locked the platform can {}.", p.name, listed(all));
}

}  // namespace pmreport::section
