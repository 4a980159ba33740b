#include <reports/section/common/words/screw_words.hpp>
#include <reports/section/common/words/words.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pmreport::section {

using Eigen::Vector3d;
using mechanics::Screw;

namespace {

std::string triple(const Vector3d& v, int digits) {
  std::string out;
  for (int k = 0; k < 3; ++k) {
    // Three digits of the largest component: smaller ones show no more decimals, and rounding no digits at all.
    const double step = std::pow(10.0, std::floor(std::log10(std::max(v.cwiseAbs().maxCoeff(), 1e-300))) + 1 - digits);
    const double shown = std::round(v(k) / step) * step;
    out += (k > 0 ? ", " : "") + typeset(format_number(shown + 0.0, digits + 1));
  }
  return "(" + out + ")";
}

const Joint& joint_of(const Surroundings& s, int j) { return s.machine.topology().joints[static_cast<std::size_t>(j)]; }
const mechanics::JointState& place_of(const Surroundings& s, int j) { return s.state.joints[static_cast<std::size_t>(j)]; }

// The joint's axis `k` as it is called.
std::string axis_name(const Surroundings& s, int j, int k) {
  const Joint& joint = joint_of(s, j);
  return axes_of(joint.kind) > 1 ? fmt::format("axis {} of {}", k + 1, joint.name) : "the axis of " + joint.name;
}

// Joints whose centres lie on the axis, each place once.
std::vector<std::string> joints_on(const Surroundings& s, const Screw& screw) {
  std::vector<std::string> names;
  std::vector<Vector3d> places;
  for (const int j : s.joints) {
    const Vector3d& c = place_of(s, j).centre;
    if (!screw.passes(c, s.length) || joint_of(s, j).kind == JointKind::prismatic) continue;
    if (std::any_of(places.begin(), places.end(), [&](const Vector3d& p) { return (p - c).norm() < 1e-6 * s.length; })) continue;
    places.push_back(c), names.push_back(joint_of(s, j).name);
  }
  constexpr std::size_t enough = 4;
  if (names.size() > enough) names.resize(enough);
  return names;
}

std::string axis_of_joint(const Surroundings& s, const Screw& screw) {
  for (const int j : s.joints)
    for (int k = 0; k < axes_of(joint_of(s, j).kind); ++k)
      if (joint_of(s, j).kind != JointKind::prismatic && screw.same_axis(place_of(s, j).centre, place_of(s, j).axis[k], s.length))
        return axis_name(s, j, k);
  return "";
}

// "the line through S1 and S2", "the axis of B5", "X through A5", "(0, 0.6, 0.8) through (1, 2, 3) mm".
std::string line_words(const Surroundings& s, const Screw& screw) {
  const std::vector<std::string> on = joints_on(s, screw);
  if (on.size() > 1) return "the line through " + listed(on);
  if (const std::string own = axis_of_joint(s, screw); !own.empty()) return own;
  return direction_words(s, screw.direction) + " through " + (on.empty() ? point_words(screw.point, s.length) : on[0]);
}

}  // namespace

Surroundings surroundings(const mechanics::Machine& machine, const mechanics::State& state, double length) {
  Surroundings s{machine, state, length, {}};
  for (int j = 0; j < static_cast<int>(state.joints.size()); ++j) s.joints.push_back(j);
  return s;
}

std::string direction_words(const Surroundings& s, const Vector3d& unit) {
  Screw d;
  d.direction = unit;
  for (int k = 0; k < 3; ++k)
    if (d.parallel(Vector3d::Unit(k))) return std::string(1, "XYZ"[k]);
  for (const int j : s.joints)
    for (int k = 0; k < axes_of(joint_of(s, j).kind); ++k)
      if (d.parallel(place_of(s, j).axis[k])) return fmt::format("{} {}", axis_name(s, j, k), triple(unit, 3));
  return triple(unit, 3);
}

std::string point_words(const Vector3d& point, double length) {
  const DisplayUnit d = display_unit("m", std::max(point.cwiseAbs().maxCoeff(), length));
  Vector3d shown = point;
  for (int k = 0; k < 3; ++k)
    if (std::abs(shown(k)) < 1e-6 * length) shown(k) = 0;
  return triple(shown * d.per_si, 4) + " " + d.label;
}

std::string wrench_words(const Surroundings& s, const Screw& w) {
  if (w.is_free()) return "a couple about " + direction_words(s, w.direction);
  if (w.is_line()) return "a force along " + line_words(s, w);
  return fmt::format("a wrench of pitch {} along {}", show(w.pitch, "m", 3), line_words(s, w));
}

std::string twist_words(const Surroundings& s, const Screw& t) {
  if (t.is_free()) return fmt::format("move along {} without turning", direction_words(s, t.direction));
  if (t.is_line()) return "turn about " + line_words(s, t);
  return fmt::format("turn about {} while it moves along this axis by {} a radian", line_words(s, t), show(t.pitch, "m", 3));
}

std::string kinds_of(const std::vector<mechanics::NamedWrench>& wrenches) {
  int forces = 0, couples = 0, others = 0;
  for (const auto& w : wrenches) ++(w.screw.is_free() ? couples : w.screw.is_line() ? forces : others);
  std::vector<std::string> parts;
  if (forces > 0) parts.push_back(plural(forces, "force"));
  if (couples > 0) parts.push_back(plural(couples, "couple"));
  if (others > 0) parts.push_back(plural(others, "wrench with a pitch", "wrenches with pitches"));
  return parts.empty() ? "none" : listed(parts);
}

}  // namespace pmreport::section
