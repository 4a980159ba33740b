#include <reports/section/common/words.hpp>
#include <reports/section/singularity/singularity.hpp>

#include <fmt/core.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace pmreport::section {

using mechanics::Singularity;
using mechanics::SingularityType;

AlongMotion along_motion(const Analysis& a, double length) {
  const auto n = static_cast<std::size_t>(a.samples());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  AlongMotion out{std::vector<double>(n, nan), std::vector<double>(n, nan), std::vector<double>(n, nan)};
  const mechanics::Machine& m = a.machine();
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t k) {
    if (a.outcome(static_cast<int>(k)) == Outcome::unreachable) return;
    const mechanics::Pose pose = a.pose(static_cast<int>(k));
    double g[36];
    if (pose.status != PM_OK || m.jacobian(PM_VALUE, 1, pose.numbers.data(), g) != PM_OK) return;
    const mechanics::Matrix6d jacobian = Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(g);
    if (!jacobian.allFinite()) return;
    const mechanics::Conditioning c = mechanics::conditioning(m, jacobian, length);
    out.determinant[k] = c.determinant, out.smallest[k] = c.smallest, out.condition[k] = c.condition();
  });
  for (std::size_t k = 0; k < n; ++k)
    if (std::isfinite(out.smallest[k]) && (out.worst < 0 || out.smallest[k] < out.smallest[static_cast<std::size_t>(out.worst)]))
      out.worst = static_cast<int>(k);
  return out;
}

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
