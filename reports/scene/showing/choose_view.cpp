#include <algorithm>
#include <cmath>
#include <core/numbers.hpp>
#include <numbers>
#include <reports/scene/look.hpp>
#include <reports/scene/showing/choose_view.hpp>
#include <reports/scene/showing/visible.hpp>

namespace pmreport::scene {

namespace {

using mechanics::Machine;
using mechanics::Pose;

constexpr int width = 96, height = 72;  // [px] of the pictures that are looked at
// How much each of them counts, of 1 in all.
constexpr double weight_limbs = 0.38, weight_least = 0.12, weight_platform = 0.1, weight_joints = 0.2, weight_middle = 0.15;
constexpr double weight_base = 0.05;
constexpr double length_of_axes = 0.23;  // of the overall size
constexpr double nearly = 0.95;          // of the best: the isometric view is kept
constexpr double alike = 0.01;           // in visibility
constexpr double in_front = 0.08;

// The parts that are to be seen: the base, which is 0, each other body, the joints that each body carries, and the middle: the line
// from the base's frame to the platform's, and their z axes.
struct Parts {
  Scene scene;
  std::vector<int> part;
  int bodies;  // parts from here on are joints
  int middle() const { return 2 * bodies; }
  int count() const { return middle() + 1; }
};

Parts parts_of(const Machine& machine, const Pose& pose) {
  const Sizes sizes = measure(machine);
  Parts out{{}, {}, static_cast<int>(machine.topology().bodies.size())};
  add_bodies(out.scene, machine, pose, sizes);
  for (const Solid& s : out.scene.solids) out.part.push_back(s.body);
  const std::size_t first = out.scene.solids.size();
  add_joints(out.scene, machine, pose, sizes);
  for (std::size_t k = first; k < out.scene.solids.size(); ++k) out.part.push_back(out.bodies + out.scene.solids[k].body);
  const int platform = machine.topology().platform;
  const Eigen::Vector3d foot = machine.origin(pose, 0), head = machine.origin(pose, platform);
  const double axis = length_of_axes * sizes.overall;
  for (const auto& [from, to] : {std::pair{foot, head},
                                 {foot, Eigen::Vector3d(foot + axis * machine.rotation(pose, 0).col(2))},
                                 {head, Eigen::Vector3d(head + axis * machine.rotation(pose, platform).col(2))}}) {
    out.scene.solids.push_back(cylinder(from, to, 0, palette::ink));
    out.part.push_back(out.middle());
  }
  return out;
}

Camera camera_of(const Bounds& bounds, const Direction& d) {
  return frame(bounds, d.azimuth, d.elevation, static_cast<double>(width) / height);
}

double away(const Direction& a, const Direction& b) {
  const auto axis = [](const Direction& d) {
    return Eigen::Vector3d(std::sin(d.azimuth) * std::cos(d.elevation), -std::cos(d.azimuth) * std::cos(d.elevation),
                           std::sin(d.elevation));
  };
  return std::acos(std::clamp(axis(a).dot(axis(b)), -1.0, 1.0));
}

}  // namespace

Direction isometric() { return {45 * deg, std::atan(1 / std::numbers::sqrt2)}; }

// A part whose half is seen is known almost as well as a whole one: the square root of the share counts. The least of the limbs' parts
// counts once more, so that none is left out for the sake of the others. What stands before the middle, as a tower or a leg before the
// platform, hides little and yet is what a reader sees first: how much of it is not covered counts by itself.
std::vector<double> visibility(const Machine& machine, const std::vector<Pose>& poses, const Bounds& bounds,
                               const std::vector<Direction>& directions) {
  std::vector<double> sum(directions.size(), 0);
  const int platform = machine.topology().platform;
  for (const Pose& pose : poses) {
    const Parts parts = parts_of(machine, pose);
    std::vector<std::vector<Visible>> seen;
    for (const Direction& d : directions)
      seen.push_back(visible(parts.scene, parts.part, parts.count(), camera_of(bounds, d), width, height));
    std::vector<int> largest(static_cast<std::size_t>(parts.count()), 0);
    for (const auto& view : seen)
      for (std::size_t p = 0; p < view.size(); ++p) largest[p] = std::max(largest[p], view[p].alone);
    for (std::size_t k = 0; k < directions.size(); ++k) {
      double limbs = 0, joints = 0, of_platform = 0, of_base = 0, least = 1;
      int bodies = 0, carriers = 0;
      for (int p = 0; p < parts.middle(); ++p) {
        const auto at = static_cast<std::size_t>(p);
        if (largest[at] == 0) continue;
        const double share = std::sqrt(static_cast<double>(seen[k][at].seen) / largest[at]);
        if (p == 0)
          of_base = share;
        else if (p == platform)
          of_platform = share;
        else if (p < parts.bodies)
          limbs += share, ++bodies, least = std::min(least, share);
        else
          joints += share, ++carriers;
      }
      const auto clear = [&](int p) {
        const Visible& v = seen[k][static_cast<std::size_t>(p)];
        return v.alone > 0 ? static_cast<double>(v.seen) / v.alone : 1.0;
      };
      const double middle = (clear(platform) + clear(parts.middle())) / 2;
      sum[k] += weight_middle * middle + weight_limbs * (bodies > 0 ? limbs / bodies : 1) + weight_least * least +
                weight_platform * of_platform + weight_base * of_base + weight_joints * (carriers > 0 ? joints / carriers : 1);
    }
  }
  for (double& s : sum) s /= static_cast<double>(std::max<std::size_t>(1, poses.size()));
  return sum;
}

Direction choose_direction(const Machine& machine, const std::vector<Pose>& poses, const Bounds& bounds) {
  std::vector<Direction> all{isometric()};
  for (int azimuth = -180; azimuth < 180; azimuth += 15)
    if (azimuth % 90 != 0)
      for (const double elevation : {15 * deg, 25 * deg, isometric().elevation, 45 * deg}) all.push_back({azimuth * deg, elevation});
  std::stable_sort(all.begin(), all.end(), [](const Direction& a, const Direction& b) {
    return std::lround(1e6 * away(a, isometric())) < std::lround(1e6 * away(b, isometric()));
  });
  const std::vector<double> seen = visibility(machine, poses, bounds, all);
  const double most = *std::max_element(seen.begin(), seen.end());
  if (seen.front() >= nearly * most) return all.front();
  const auto first = std::find_if(seen.begin(), seen.end(), [&](double s) { return s >= most - alike; });
  return all[static_cast<std::size_t>(first - seen.begin())];
}

bool base_is_in_front(const Machine& machine, const std::vector<Pose>& poses, const Bounds& bounds, const Direction& direction) {
  int with = 0, without = 0;
  for (const Pose& pose : poses) {
    Parts parts = parts_of(machine, pose);
    const Camera camera = camera_of(bounds, direction);
    const auto count = [&] {
      int sum = 0;
      const std::vector<Visible> all = visible(parts.scene, parts.part, parts.count(), camera, width, height);
      for (std::size_t p = 1; p < all.size(); ++p) sum += all[p].seen;
      return sum;
    };
    with += count();
    std::replace(parts.part.begin(), parts.part.end(), 0, -2);
    without += count();
  }
  return without - with > in_front * without;
}

}  // namespace pmreport::scene
