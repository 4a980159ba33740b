#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector3d;

Solid on(int body, Solid solid) {
  solid.body = body;
  return solid;
}

void add_hinge(Scene& scene, int body, const Vector3d& c, const Vector3d& axis, double r) {
  const Vector3d end = 1.25 * r * axis, cap = 0.26 * r * axis;
  scene.solids.push_back(on(body, cylinder(c - end, c + end, 0.72 * r, palette::revolute)));
  scene.solids.push_back(on(body, cylinder(c + end - cap, c + end, 0.98 * r, palette::revolute)));
  scene.solids.push_back(on(body, cylinder(c - end, c - end + cap, 0.98 * r, palette::revolute)));
}

// A centre line as drawings have it: long dash, dot, long dash.
void add_centre_line(Scene& scene, const Vector3d& c, const Vector3d& axis, double half, double unit) {
  const double dash = 1.1 * unit, gap = 0.35 * unit, dot = 0.15 * unit;
  for (double s = -half; s < half; s += dash + 2 * gap + dot) {
    scene.lines.push_back({{c + s * axis, c + std::min(s + dash, half) * axis}, palette::ink, 1.4, 0.3f});
    const double d = s + dash + gap;
    if (d + dot < half) scene.lines.push_back({{c + d * axis, c + (d + dot) * axis}, palette::ink, 1.4, 0.3f});
  }
}

void add_bar(Scene& scene, int body, const Vector3d& c, const Vector3d& axis, double r) {
  scene.solids.push_back(on(body, cylinder(c - 1.2 * r * axis, c + 1.2 * r * axis, 0.44 * r, palette::universal)));
  for (const double end : {-1.2 * r, 1.2 * r})
    scene.solids.push_back(on(body, cylinder(c + 0.86 * end * axis, c + 1.06 * end * axis, 0.58 * r, palette::universal)));
}

}  // namespace

void add_joints(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const Sizes& sizes) {
  const Topology& t = machine.topology();
  for (std::size_t k = 0; k < t.joints.size(); ++k) {
    const int j = static_cast<int>(k);
    const int a = t.joints[k].a;  // its symbol rests in both bodies, but for a cross
    const double r = sizes.joints[k];
    const Vector3d c = machine.centre(pose, j);
    switch (t.joints[k].kind) {
      case JointKind::spherical:
        scene.solids.push_back(on(a, ball(c, r, palette::spherical)));
        break;
      case JointKind::revolute:
        add_hinge(scene, a, c, machine.axis(pose, j), r);
        add_centre_line(scene, c, machine.axis(pose, j), 3.4 * r, r);
        break;
      case JointKind::universal:
        // Each bar of the cross turns with the body that its axis is fixed in.
        add_bar(scene, a, c, machine.axis(pose, j, 0), r);
        add_bar(scene, t.joints[k].b, c, machine.axis(pose, j, 1), r);
        break;
      case JointKind::cylindrical: {
        const Vector3d half = 1.2 * r * machine.axis(pose, j);
        scene.solids.push_back(on(a, cylinder(c - half, c + half, 0.8 * r, palette::cylindrical)));
        break;
      }
      case JointKind::prismatic:
        break;  // its rail, or its tube and rod, show it
    }
  }
}

}  // namespace pmreport::scene
