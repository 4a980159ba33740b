#include <algorithm>
#include <limits>
#include <reports/scene/look.hpp>
#include <reports/scene/showing/overlay.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector3d;
using mechanics::Machine;
using mechanics::Pose;

constexpr float between = 0.30f;     // opacity of the poses between
constexpr double told_apart = 0.02;  // of the overall size

// Its joints, its origin and the tips of its axes, for it may turn about a joint of its own.
std::vector<Vector3d> points_of_platform(const Machine& machine, const Pose& pose, double axis) {
  const Topology& t = machine.topology();
  std::vector<Vector3d> out{machine.origin(pose, t.platform)};
  for (int k = 0; k < 3; ++k) out.push_back(out.front() + axis * machine.rotation(pose, t.platform).col(k));
  for (std::size_t j = 0; j < t.joints.size(); ++j)
    if (t.joints[j].a == t.platform || t.joints[j].b == t.platform) out.push_back(machine.centre(pose, static_cast<int>(j)));
  return out;
}

double distance(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, (a[k] - b[k]).norm());
  return most;
}

}  // namespace

Scene build(const Machine& machine, const Overlay& overlay, const Extras& extras) {
  const std::vector<Pose>& poses = overlay.poses;
  Extras first = extras;
  first.joint_names = false;
  Scene scene = build(machine, poses.front(), first);
  const Sizes sizes = measure(machine);
  for (std::size_t k = 1; k < poses.size(); ++k) {
    Scene other;
    add_bodies(other, machine, poses[k], sizes);
    add_joints(other, machine, poses[k], sizes);
    for (Solid& s : other.solids) {
      if (s.body == 0) continue;
      if (overlay.returns || k + 1 < poses.size()) s.color.a = between;
      s.body += static_cast<int>(k * machine.topology().bodies.size());  // each pose has its own outlines
      scene.solids.push_back(std::move(s));
    }
  }
  for (const Mark& mark : overlay.marks) {
    const double dot = (mark.of_pose ? 0.45 : 0.26) * sizes.joint;
    scene.solids.push_back(ball(mark.at, dot, palette::path, 0.8f));
    if (extras.labels) scene.labels.push_back({mark.at, mark.text, palette::path, dot, !mark.of_pose});
  }
  return scene;
}

std::vector<std::size_t> spread(const Machine& machine, const std::vector<Pose>& poses, std::size_t count) {
  if (poses.empty()) return {};
  const double overall = measure(machine).overall, least = told_apart * overall;
  std::vector<std::vector<Vector3d>> at;
  for (const Pose& p : poses) at.push_back(points_of_platform(machine, p, 0.25 * overall));
  std::vector<std::size_t> chosen{0};
  std::vector<double> away(poses.size(), std::numeric_limits<double>::infinity());
  const auto take = [&](std::size_t index) {
    for (std::size_t k = 0; k < at.size(); ++k) away[k] = std::min(away[k], distance(at[k], at[index]));
    if (index != chosen.front()) chosen.push_back(index);
  };
  take(0);
  if (count > 1 && away.back() > least) take(poses.size() - 1);
  while (chosen.size() < count) {
    const auto farthest = std::max_element(away.begin(), away.end());
    if (*farthest <= least) break;
    take(static_cast<std::size_t>(farthest - away.begin()));
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace pmreport::scene
