#include <algorithm>
#include <cmath>
#include <limits>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

using Eigen::Vector3d;
using mechanics::Machine;
using mechanics::Pose;

Sizes measure(const Machine& machine) {
  const Topology& t = machine.topology();
  const Pose& home = machine.home_pose();
  Bounds box;
  for (int j = 0; j < static_cast<int>(t.joints.size()); ++j) box.include(machine.centre(home, j));
  Sizes s;
  if (const double diagonal = (box.high - box.low).norm(); diagonal > 0) s.overall = diagonal / std::sqrt(3.0);
  s.joint = 0.025 * s.overall;
  for (std::size_t k = 0; k < t.joints.size(); ++k) {
    const Vector3d c = machine.centre(home, static_cast<int>(k));
    double thickest = 0;
    for (const Shape& shape : t.shapes) {
      if (shape.kind != ShapeKind::cylinder || (shape.body != t.joints[k].a && shape.body != t.joints[k].b)) continue;
      for (const Vector3d& end : {shape.a, shape.b})
        if ((machine.origin(home, shape.body) + machine.rotation(home, shape.body) * end - c).norm() < 2 * shape.radius)
          thickest = std::max(thickest, shape.radius);
    }
    s.joints.push_back(std::min(std::max(s.joint, 1.28 * thickest), 3 * s.joint));
  }
  return s;
}

double overall_size(const Machine& machine) { return measure(machine).overall; }

namespace {

void include(Bounds& bounds, const Solid& s) {
  if (s.kind == Solid::Kind::plate)
    for (std::size_t k = 0; k < s.outline.size(); k += 4) bounds.include(s.outline[k], s.radius / 2);  // its arcs are fine
  else if (s.kind == Solid::Kind::box)
    for (const Eigen::Vector3d& corner : corners(s)) bounds.include(corner);
  else
    bounds.include(s.a, s.radius);
  if (s.kind == Solid::Kind::cylinder || s.kind == Solid::Kind::cone) bounds.include(s.b, s.radius);
}

Scene solids_of(const Machine& machine, const Pose& pose, const Sizes& sizes) {
  Scene scene;
  add_bodies(scene, machine, pose, sizes);
  add_joints(scene, machine, pose, sizes);
  return scene;
}

// A round step, 1, 2 or 5 times a power of ten, about a fifth of the machine.
double grid_step(double overall) {
  const double wanted = overall / 5, decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double step : {1.0, 2.0, 5.0})
    if (wanted <= 1.4 * step * decade) return step * decade;
  return 10 * decade;
}

}  // namespace

void include(Bounds& bounds, const Machine& machine, const Pose& pose) {
  const Sizes sizes = measure(machine);
  for (const Solid& s : solids_of(machine, pose, sizes).solids) include(bounds, s);
  bounds.include(machine.origin(pose, machine.topology().platform), 0.27 * sizes.overall);  // its frame and arrows
  for (int k = 0; k < 3; ++k) bounds.include(machine.origin(pose, 0) + 0.26 * sizes.overall * machine.rotation(pose, 0).col(k));
}

void include(Bounds& bounds, const Surface& surface) {
  for (const Vector3d& p : surface.points)
    if (p.allFinite()) bounds.include(p);
}

std::array<Eigen::Vector3d, 8> corners(const Solid& box) {
  std::array<Eigen::Vector3d, 8> out;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] =
        box.a + box.axes * Eigen::Vector3d(i & 1 ? box.b.x() : -box.b.x(), i & 2 ? box.b.y() : -box.b.y(), i & 4 ? box.b.z() : -box.b.z());
  return out;
}

Scene build(const Machine& machine, const Pose& pose, const Extras& extras) {
  const Topology& t = machine.topology();
  const Sizes sizes = measure(machine);
  Scene scene;
  add_bodies(scene, machine, pose, sizes);
  for (Solid& s : scene.solids)
    if (s.body == 0) s.color.a = extras.base_opacity;
  add_joints(scene, machine, pose, sizes);
  Bounds at_home;
  for (const Solid& s : solids_of(machine, machine.home_pose(), sizes).solids) include(at_home, s);
  scene.ground = at_home.low.z();
  scene.grid = grid_step(sizes.overall);

  if (extras.frames) {
    constexpr const char* base_names[] = {"O", "X", "Y", "Z"};
    constexpr const char* platform_names[] = {"o", "x", "y", "z"};
    add_frame(scene, machine.origin(pose, 0), machine.rotation(pose, 0), base_names, 0.24 * sizes.overall);
    add_frame(scene, machine.origin(pose, t.platform), machine.rotation(pose, t.platform), platform_names, 0.22 * sizes.overall);
  }
  add_extras(scene, machine, pose, sizes, extras);
  scene.surfaces = extras.surfaces;
  scene.lines.insert(scene.lines.end(), extras.lines.begin(), extras.lines.end());
  if (!extras.labels) scene.labels.clear();
  if (extras.labels) {
    add_drive_names(scene, machine, pose, extras.drives);
    for (std::size_t k = 0; k < t.joints.size() && extras.joint_names; ++k)
      if (t.joints[k].kind != JointKind::prismatic)
        scene.labels.push_back({machine.centre(pose, static_cast<int>(k)), t.joints[k].name, palette::ink, 0});
  }
  return scene;
}

void add_drive_names(Scene& scene, const Machine& machine, const Pose& pose, const std::vector<std::string>& names) {
  const Topology& t = machine.topology();
  const std::vector<Drive> drives = drives_of_bodies(t);
  for (std::size_t i = 0; i < t.actuators.size(); ++i) {
    Label label{machine.centre(pose, t.actuators[i].joint), i < names.size() ? names[i] : t.actuators[i].name,
                curve_color(static_cast<int>(i)), 0};
    double most = 0;
    for (const Solid& s : scene.solids) {
      const Drive& d = drives[static_cast<std::size_t>(s.body)];
      const double length = s.kind == Solid::Kind::cylinder ? (s.b - s.a).norm() : s.kind == Solid::Kind::box ? 2 * s.b.maxCoeff() : 0;
      if (d.actuator != static_cast<int>(i) || !d.driven || length <= most) continue;
      most = length;
      label.at = s.kind == Solid::Kind::cylinder ? Vector3d((s.a + s.b) / 2) : s.a;
      label.clear = s.kind == Solid::Kind::cylinder ? s.radius : s.b.minCoeff();
    }
    scene.labels.push_back(std::move(label));
  }
}

}  // namespace pmreport::scene
