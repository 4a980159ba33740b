#include <core/mechanics/machine/limb_line.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::mechanics {

namespace {

constexpr double on_the_line = 1e-9;  // of the line's length

int other_end(const Joint& joint, int body) { return joint.a == body ? joint.b : joint.a; }

}  // namespace

int limbs_of(const Topology& topology) {
  int out = 0;
  for (const Body& b : topology.bodies) out = std::max(out, b.limb);
  return out;
}

std::optional<LimbLine> limb_line(const Machine& machine, int limb, std::string* why) {
  const Topology& t = machine.topology();
  const auto none = [&](const char* sentence) {
    if (why != nullptr) *why = sentence;
    return std::nullopt;
  };
  const auto own = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].limb == limb; };
  if (limb < 1 || limb > limbs_of(t)) return none("does not exist");

  LimbLine out;
  out.limb = limb;
  int far_body = -1;
  bool at_platform = false;
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    if (own(joint.a) == own(joint.b)) continue;
    const int body = own(joint.a) ? joint.a : joint.b;
    const bool platform = other_end(joint, body) == t.platform;
    if (at_platform && platform) return none("meets the platform in several joints, and is no single line");
    if (at_platform && !platform) continue;
    if (platform || body > far_body) out.to = static_cast<int>(j), far_body = body, at_platform = platform;
  }
  if (far_body < 0) return none("has no joint to another body");

  // From its far joint back over what slides, to the joint that ends the line.
  std::vector<int> bodies{far_body};
  int arrived = out.to;
  bool ended = false;
  while (!ended) {
    int next = -1;
    for (std::size_t j = 0; j < t.joints.size() && next < 0; ++j) {
      const Joint& joint = t.joints[j];
      if (static_cast<int>(j) == arrived || (joint.a != bodies.back() && joint.b != bodies.back())) continue;
      const int beyond = other_end(joint, bodies.back());
      // A chain's joint to another limb that is hinged on this one ends nothing.
      if (!own(beyond) && beyond != 0 && at_platform && t.bodies[static_cast<std::size_t>(beyond)].limb != 0) continue;
      next = static_cast<int>(j);
    }
    if (next < 0) return none("ends in one joint, and is no line");
    const Joint& joint = t.joints[static_cast<std::size_t>(next)];
    const int beyond = other_end(joint, bodies.back());
    if (joint.kind == JointKind::prismatic && own(beyond)) {
      bodies.push_back(beyond), arrived = next;
      if (bodies.size() > t.bodies.size()) return none("slides in a circle");
    } else {
      out.from = next, ended = true;
    }
  }

  const Pose& home = machine.home_pose();
  const Eigen::Vector3d a = machine.centre(home, out.from), b = machine.centre(home, out.to);
  const double length = (b - a).norm();
  if (!(length > 0)) return none("has no length at home");
  const Eigen::Vector3d u = (b - a) / length;
  double low = 0, high = length;
  out.low = out.from, out.high = out.to;
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    const bool mine_a = std::ranges::find(bodies, joint.a) != bodies.end(), mine_b = std::ranges::find(bodies, joint.b) != bodies.end();
    if (mine_a == mine_b) continue;
    out.joints.push_back(static_cast<int>(j));
    const Eigen::Vector3d p = machine.centre(home, static_cast<int>(j)) - a;
    const double along = u.dot(p);
    if ((p - along * u).norm() > on_the_line * length) continue;
    if (along < low) low = along, out.low = static_cast<int>(j);
    if (along > high) high = along, out.high = static_cast<int>(j);
  }
  for (const Shape& s : t.shapes)
    if (s.kind == ShapeKind::cylinder && std::ranges::find(bodies, s.body) != bodies.end() && s.a.head<2>().isZero(on_the_line) &&
        s.b.head<2>().isZero(on_the_line))
      out.radius = std::max(out.radius, s.radius);
  return out;
}

namespace {

// Of a slide whose bodies hold one joint more each.
std::optional<TelescopicDrive> lone_telescope(const Machine& machine, int slide) {
  const Topology& t = machine.topology();
  const auto beyond = [&](int body) {
    int found = -1;
    for (std::size_t j = 0; j < t.joints.size(); ++j) {
      if (static_cast<int>(j) == slide || (t.joints[j].a != body && t.joints[j].b != body)) continue;
      if (found >= 0) return -1;
      found = static_cast<int>(j);
    }
    return found;
  };
  const Joint& joint = t.joints[static_cast<std::size_t>(slide)];
  const TelescopicDrive out{beyond(joint.a), beyond(joint.b)};
  if (joint.a == 0 || joint.b == 0 || joint.a == t.platform || joint.b == t.platform || out.near < 0 || out.far < 0) return std::nullopt;
  const Pose& home = machine.home_pose();
  const Eigen::Vector3d along = machine.centre(home, out.far) - machine.centre(home, out.near);
  if (!(along.norm() > 0) || along.cross(machine.axis(home, slide)).norm() > on_the_line * along.norm()) return std::nullopt;
  return out;
}

}  // namespace

std::optional<TelescopicDrive> telescopic_drive(const Machine& machine, int actuator) {
  const Topology& t = machine.topology();
  const int slide = t.actuators[static_cast<std::size_t>(actuator)].joint;
  const Joint& joint = t.joints[static_cast<std::size_t>(slide)];
  if (joint.kind != JointKind::prismatic) return std::nullopt;
  const int limb = t.bodies[static_cast<std::size_t>(joint.b)].limb;
  const auto holds = [&](int other, int body) {
    const Joint& j = t.joints[static_cast<std::size_t>(other)];
    return j.a == body || j.b == body;
  };
  const std::optional<LimbLine> line = limb_line(machine, limb);
  const auto between = [&](int from, int to) { return holds(line->from, from) && holds(line->to, to); };
  if (line && limb == t.bodies[static_cast<std::size_t>(joint.a)].limb && (between(joint.a, joint.b) || between(joint.b, joint.a)))
    return TelescopicDrive{line->from, line->to};
  return lone_telescope(machine, slide);
}

bool adjacent(const Machine& machine, const LimbLine& a, const LimbLine& b) {
  for (const int i : a.joints)
    if (std::ranges::find(b.joints, i) != b.joints.end()) return true;
  const Pose& home = machine.home_pose();
  const auto at = [&](int joint) { return machine.centre(home, joint); };
  const double length = (at(a.high) - at(a.low)).norm();
  for (const int i : {a.low, a.high})
    for (const int k : {b.low, b.high})
      if ((at(i) - at(k)).norm() <= on_the_line * length) return true;
  return false;
}

}  // namespace pmreport::mechanics
