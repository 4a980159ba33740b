#include <core/mechanics/conformance/oddities.hpp>

#include <core/text/units.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace pmreport::mechanics {

using Eigen::Vector3d;

AtHome::AtHome(const Machine& machine) : topology_(machine.topology()) {
  const Pose& pose = machine.home_pose();
  for (int i = 0; i < bodies(); ++i) {
    origin_.push_back(machine.origin(pose, i)), rotation_.push_back(machine.rotation(pose, i));
    limbs_ = std::max(limbs_, body(i).limb);
  }
  joints_of_.resize(static_cast<std::size_t>(bodies()));
  std::vector<int> all;
  for (int j = 0; j < static_cast<int>(topology_.joints.size()); ++j) {
    all.push_back(j), centre_.push_back(machine.centre(pose, j));
    joints_of_[static_cast<std::size_t>(joint(j).a)].push_back(j);
    joints_of_[static_cast<std::size_t>(joint(j).b)].push_back(j);
  }
  span_ = apart(all);
  for (std::size_t i = 0; i < topology_.actuators.size(); ++i)
    actuator_.push_back(pose.numbers[machine.layout().actuator(static_cast<int>(i))]);

  // The structure of a limb in letters: of each of its joints the kind, and what it joins; own bodies by their place in the limb, others by
  // their number where they belong to no limb.
  std::map<std::string, std::size_t> groups;
  for (int limb = 1; limb <= limbs_; ++limb) {
    const std::vector<int> own = bodies_of(limb);
    if (own.empty()) continue;
    std::string structure = std::to_string(own.size());
    for (const int j : joints_of_limb(limb)) {
      structure += "; " + std::to_string(static_cast<int>(joint(j).kind));
      for (const int end : {joint(j).a, joint(j).b}) {
        const auto at = std::find(own.begin(), own.end(), end);
        structure += at != own.end()       ? " own " + std::to_string(at - own.begin())
                     : body(end).limb == 0 ? " body " + std::to_string(end)
                                           : " other limb";
      }
    }
    const auto [found, is_new] = groups.emplace(structure, alike_.size());
    if (is_new) alike_.emplace_back();
    alike_[found->second].push_back(limb);
  }
}

Vector3d AtHome::seat(int j, int i) const {
  const auto at = static_cast<std::size_t>(i);
  return rotation_[at].transpose() * (centre(j) - origin_[at]);
}

Vector3d AtHome::in_socket(int j, const Vector3d& direction) const {
  const int socket = joint(j).stud == joint(j).a ? joint(j).b : joint(j).a;
  return rotation_[static_cast<std::size_t>(socket)].transpose() * direction;
}

Vector3d AtHome::stud(int j) const { return rotation_[static_cast<std::size_t>(joint(j).stud)].col(2); }

double AtHome::apart(const std::vector<int>& joints) const {
  double most = 0;
  for (const int a : joints)
    for (const int b : joints) most = std::max(most, (centre(a) - centre(b)).norm());
  return most;
}

Eigen::AlignedBox3d AtHome::box(int i) const {
  Eigen::AlignedBox3d out;
  for (const int j : joints_of(i)) out.extend(seat(j, i));
  for (const Shape& s : topology_.shapes) {
    if (s.body != i) continue;
    if (s.kind == ShapeKind::box) {
      out.extend(s.a - s.b.cwiseAbs()), out.extend(s.a + s.b.cwiseAbs());
      continue;
    }
    // A disc across unit u reaches r sqrt(1 - u_k^2) along axis k.
    Vector3d half = Vector3d::Constant(s.radius);
    const Vector3d along = s.b - s.a, b = s.kind == ShapeKind::ball ? s.a : s.b;
    if (s.kind == ShapeKind::cylinder && along.norm() > 0)
      half = s.radius * (Vector3d::Ones() - along.normalized().cwiseAbs2()).cwiseMax(0).cwiseSqrt();
    for (const Vector3d& end : {s.a, b}) out.extend(end - half), out.extend(end + half);
  }
  return out;
}

double AtHome::drawn_volume(int i) const {
  double volume = 0;
  for (const Shape& s : topology_.shapes) {
    if (s.body != i) continue;
    if (s.kind == ShapeKind::box)
      volume += 8 * std::abs(s.b.prod());
    else if (s.kind == ShapeKind::ball)
      volume += 4.0 / 3 * std::numbers::pi * std::pow(s.radius, 3);
    else
      volume += std::numbers::pi * s.radius * s.radius * (s.b - s.a).norm();
  }
  return volume;
}

double AtHome::drawn_size(int i) const {
  double size = 0;
  for (const Shape& s : topology_.shapes)
    if (s.body == i)
      size = std::max({size, 2 * s.radius, s.kind == ShapeKind::box ? 2 * s.b.cwiseAbs().maxCoeff() : 0,
                       s.kind == ShapeKind::cylinder ? (s.b - s.a).norm() : 0});
  return size;
}

double AtHome::joints_apart(int limb) const { return apart(joints_of_limb(limb)); }

double AtHome::longest_drive(int limb) const {
  double most = 0;
  for (const Actuator& a : topology_.actuators) {
    const Joint& j = joint(a.joint);
    if (a.sense() == Sense::linear && (body(j.a).limb == limb || body(j.b).limb == limb))
      most = std::max({most, std::abs(a.stroke.min), std::abs(a.stroke.max)});
  }
  return most;
}

std::vector<int> AtHome::bodies_of(int limb) const {
  std::vector<int> out;
  for (int i = 1; i < bodies(); ++i)
    if (body(i).limb == limb) out.push_back(i);
  return out;
}

std::vector<int> AtHome::joints_of_limb(int limb) const {
  std::vector<int> out;
  for (int j = 0; j < static_cast<int>(topology_.joints.size()); ++j)
    if (body(joint(j).a).limb == limb || body(joint(j).b).limb == limb) out.push_back(j);
  return out;
}

std::string length_words(double metres) {
  const bool far = std::abs(metres) >= 10;
  return format_number(far ? metres : metres * 1e3, 3) + (far ? " m" : " mm");
}

std::string angle_words(double radians) { return format_number(radians / deg, 4) + " deg"; }

}  // namespace pmreport::mechanics
