#include <core/mechanics/transmission/transmission_paths.hpp>

#include <core/mechanics/model/random_poses.hpp>
#include <core/text/text.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace pmreport::mechanics {

using Eigen::Vector3d;

namespace {

constexpr double on_the_line = 1e-9;  // of the length: a point, or a pitch
constexpr int looked_at = 8;          // random poses

// Poses with G, home first.
struct Sample {
  Pose pose;
  linear::Matrix6d g;
};

std::vector<Sample> samples_of(const Machine& machine) {
  std::vector<Eigen::VectorXd> at{machine.home()};
  for (Eigen::VectorXd& q : random_poses(machine, looked_at, 1)) at.push_back(std::move(q));
  std::vector<Sample> out;
  for (const Eigen::VectorXd& q : at) {
    Pose pose = machine.pose({q.data(), static_cast<std::size_t>(q.size())});
    if (pose.status != PM_OK) continue;
    if (const Jacobian g = machine.jacobian(pose); g.known()) out.push_back({std::move(pose), g.matrix});
  }
  return out;
}

bool touches(const Joint& joint, int body) { return joint.a == body || joint.b == body; }

class Search {
 public:
  Search(const Machine& machine, double length) : m_(machine), t_(machine.topology()), length_(length), samples_(samples_of(machine)) {}

  bool anything() const { return !samples_.empty(); }
  // Whether the row is a couple, or a single force, at all poses.
  bool couple(int row) const {
    return all([&](const Sample& s) { return s.g.row(row).head<3>().norm() * length_ <= on_the_line * s.g.row(row).tail<3>().norm(); });
  }
  bool force(int row) const {
    return all([&](const Sample& s) {
      const Vector3d f = s.g.row(row).head<3>(), m = s.g.row(row).tail<3>();
      const double f2 = f.squaredNorm();
      return f2 > 0 && std::abs(f.dot(m)) <= on_the_line * f2 * std::max(length_, m.norm() / f.norm());
    });
  }
  bool passes(int row, const BodyPoint& point) const {
    return all([&](const Sample& s) {
      const Vector3d f = s.g.row(row).head<3>(), m = s.g.row(row).tail<3>();
      const Vector3d r = place_of(s.pose, point) - m_.origin(s.pose, t_.platform);
      return (m - r.cross(f)).norm() <= on_the_line * f.norm() * std::max({length_, r.norm(), m.norm() / f.norm()});
    });
  }
  // The first joint of the platform that the line of a single force passes through.
  BodyPoint joint_on_the_line(int row) const {
    for (std::size_t j = 0; j < t_.joints.size(); ++j)
      if (const BodyPoint at{t_.platform, {static_cast<int>(j)}}; touches(t_.joints[j], t_.platform) && passes(row, at)) return at;
    return {};
  }

  DrivePath drive(int i) const {
    DrivePath out;
    out.telescope = telescopic_drive(m_, i);
    const Joint& driven = t_.joints[static_cast<std::size_t>(t_.actuators[static_cast<std::size_t>(i)].joint)];
    const int moved = driven.b != 0 ? driven.b : driven.a;
    for (std::size_t j = 0; j < t_.joints.size(); ++j)
      if (&t_.joints[j] != &driven && touches(t_.joints[j], moved)) out.next.push_back(static_cast<int>(j));
    if (!out.telescope) out.entry = entry_of(t_.bodies[static_cast<std::size_t>(moved)].limb, out.no_pressure);
    if (!out.telescope && out.no_pressure.empty() && couple(i))
      out.no_pressure = "it turns the platform by a couple, and pushes no point of it";
    choose_output(i, out);
    return out;
  }
  ConstraintPath constraint(int i) const {
    ConstraintPath out;
    out.couple = couple(i);
    if (out.couple) return out;
    if (!force(i)) {
      out.none = "it is a force with a couple along it, which has no point of the platform to act at";
      return out;
    }
    out.point = joint_on_the_line(i);
    if (!out.point.exists()) out.none = "the line of its force passes through no joint of the platform";
    return out;
  }

 private:
  template <class Is>
  bool all(Is&& is) const {
    return std::ranges::all_of(samples_, is);
  }
  Vector3d place_of(const Pose& pose, const BodyPoint& point) const {
    if (point.joints.empty()) return m_.origin(pose, point.body);
    Vector3d sum = Vector3d::Zero();
    for (const int j : point.joints) sum += m_.centre(pose, j);
    return sum / static_cast<double>(point.joints.size());
  }

  // Where a limb ends: its joints to one body that is of no limb and not the base. A drive of no limb pushes at the reference point.
  BodyPoint entry_of(int limb, std::string& why) const {
    if (limb == 0) return {t_.platform, {}};
    BodyPoint out;
    for (std::size_t j = 0; j < t_.joints.size(); ++j) {
      const Joint& joint = t_.joints[j];
      const auto limb_at = [&](int body) { return t_.bodies[static_cast<std::size_t>(body)].limb; };
      if ((limb_at(joint.a) == limb) == (limb_at(joint.b) == limb)) continue;
      const int beyond = limb_at(joint.a) == limb ? joint.b : joint.a;
      if (beyond == 0 || limb_at(beyond) != 0) continue;
      if (out.exists() && out.body != beyond) {
        why = fmt::format("limb {} ends in several bodies", limb);
        return {};
      }
      out.body = beyond, out.joints.push_back(static_cast<int>(j));
    }
    if (!out.exists()) why = fmt::format("limb {} holds no body of the platform", limb);
    return out;
  }

  void choose_output(int i, DrivePath& out) const {
    if (!out.telescope && !out.entry.exists()) {
      out.no_output = out.no_pressure;
    } else if (couple(i)) {
      out.no_output = "it turns the platform by a couple, and pushes no point of it";
    } else if (!out.telescope && out.entry.body != t_.platform) {
      out.no_output = fmt::format("its force enters {}, which is one of several bodies of the platform",
                                  t_.bodies[static_cast<std::size_t>(out.entry.body)].name);
    } else if (!force(i)) {
      out.no_output = "it acts on the platform by a force and a couple along it, at no one point";
    } else {
      const BodyPoint wanted = out.telescope ? BodyPoint{t_.platform, {out.telescope->far}} : out.entry;
      const bool on_platform = !out.telescope || touches(t_.joints[static_cast<std::size_t>(out.telescope->far)], t_.platform);
      if (on_platform && passes(i, wanted))
        out.output = wanted;
      else if (out.telescope)
        out.output = joint_on_the_line(i);
      if (!out.output.exists())
        out.no_output = out.telescope ? "the line of its force passes through no joint of the platform"
                                      : fmt::format("the line of its force does not pass through {}", words_of(t_, wanted));
    }
  }

  const Machine& m_;
  const Topology& t_;
  double length_;
  std::vector<Sample> samples_;
};

}  // namespace

std::string words_of(const Topology& topology, const BodyPoint& point) {
  if (point.joints.empty())
    return point.body == topology.platform ? "the platform's reference point" : topology.bodies[static_cast<std::size_t>(point.body)].name;
  std::vector<std::string> names;
  for (const int j : point.joints) names.push_back(topology.joints[static_cast<std::size_t>(j)].name);
  return (names.size() > 1 ? "the middle of " : "") + listed(names, "and");
}

TransmissionPaths transmission_paths(const Machine& machine, double length) {
  const Search search(machine, length);
  TransmissionPaths out;
  const int dof = machine.dof();
  const std::string unknown = "the mechanism gives no overall Jacobian";
  for (int i = 0; i < dof; ++i) {
    out.drives.push_back(search.anything() ? search.drive(i) : DrivePath{});
    if (!search.anything()) out.drives.back().no_pressure = out.drives.back().no_output = unknown;
  }
  for (int i = dof; i < 6; ++i) {
    out.constraints.push_back(search.anything() ? search.constraint(i) : ConstraintPath{});
    if (!search.anything()) out.constraints.back().none = unknown;
  }
  out.translates = search.anything() && dof == 3 && std::ranges::all_of(out.constraints, [](const ConstraintPath& c) { return c.couple; });
  return out;
}

}  // namespace pmreport::mechanics
