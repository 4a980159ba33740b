#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanics::Machine;
using mechanics::Pose;

constexpr double base_thickness = 0.05, platform_thickness = 0.036;  // of the overall size
constexpr double tube_share = 0.62;                                  // of a telescopic limb's length at home

bool has_shapes(const Topology& t, int body) {
  return std::any_of(t.shapes.begin(), t.shapes.end(), [&](const Shape& s) { return s.body == body; });
}
std::vector<int> joints_of(const Topology& t, int body) {
  std::vector<int> all;
  for (std::size_t k = 0; k < t.joints.size(); ++k)
    if (t.joints[k].a == body || t.joints[k].b == body) all.push_back(static_cast<int>(k));
  return all;
}
const Joint& joint(const Topology& t, int j) { return t.joints[static_cast<std::size_t>(j)]; }
double radius(const Sizes& s, int j) { return s.joints[static_cast<std::size_t>(j)]; }

// From where a slide stands at home to the ends of its travel; a slide without real limits gets a rail of moderate length.
std::pair<Vector3d, Vector3d> rail_ends(const Machine& m, int j, const Sizes& sizes) {
  const Joint& k = joint(m.topology(), j);
  Range travel{-0.35 * sizes.overall, 0.35 * sizes.overall};
  if (!k.limits.empty() && k.limits[0].max - k.limits[0].min < 4 * sizes.overall) travel = k.limits[0];
  const double over = 1.5 * radius(sizes, j);  // the carriage stays on the rail
  const Vector3d c = m.centre(m.home_pose(), j), axis = m.axis(m.home_pose(), j);
  return {c + (travel.min - over) * axis, c + (travel.max + over) * axis};
}

void add_shapes(Scene& scene, const Machine& m, const Pose& pose, int body, const Color& color) {
  const Matrix3d r = m.rotation(pose, body);
  const Vector3d o = m.origin(pose, body);
  for (const Shape& s : m.topology().shapes) {
    if (s.body != body) continue;
    switch (s.kind) {
      case ShapeKind::cylinder:
        scene.solids.push_back(cylinder(o + r * s.a, o + r * s.b, s.radius, color));
        break;
      case ShapeKind::ball:
        scene.solids.push_back(ball(o + r * s.a, s.radius, color));
        break;
      case ShapeKind::box:
        scene.solids.push_back({Solid::Kind::box, o + r * s.a, s.b, 0, r, {}, color, 0});
        break;
    }
  }
}

// Of a limb's bodies the thick ones are tubes, the thin ones rods.
Color limb_color(const Topology& t, int body) {
  double own = 0, most = 0;
  for (const Shape& s : t.shapes) {
    if (s.kind != ShapeKind::cylinder || t.bodies[static_cast<std::size_t>(s.body)].limb != t.bodies[static_cast<std::size_t>(body)].limb)
      continue;
    most = std::max(most, s.radius);
    if (s.body == body) own = std::max(own, s.radius);
  }
  return own > 0 && own < 0.85 * most ? palette::rod : palette::tube;
}

// Base and platform: the plate is made at home, where it is the same for every picture, and moved with the body.
void add_plate(Scene& scene, const Machine& m, const Pose& pose, const Sizes& sizes, int body, double thickness, const Color& color) {
  const Topology& t = m.topology();
  const Pose& home = m.home_pose();
  std::vector<Carried> points;
  for (const int j : joints_of(t, body)) {
    const bool rail = body == 0 && joint(t, j).kind == JointKind::prismatic;
    if (rail) {
      const auto [a, b] = rail_ends(m, j, sizes);
      scene.solids.push_back(cylinder(a, b, 0.5 * radius(sizes, j), palette::rod));
      points.push_back({a, radius(sizes, j)}), points.push_back({b, radius(sizes, j)});
    } else {
      points.push_back({m.centre(home, j), radius(sizes, j)});
    }
  }
  if (points.empty()) return;
  Vector3d towards = Vector3d::Zero();  // the rest of the machine
  for (const Carried& c : points) towards -= c.at / static_cast<double>(points.size());
  for (std::size_t k = 0; k < t.joints.size(); ++k) towards += m.centre(home, static_cast<int>(k)) / static_cast<double>(t.joints.size());
  Plate plate = make_plate(points, towards, m.rotation(home, body).col(2), thickness, color);

  const Matrix3d turn = m.rotation(pose, body) * m.rotation(home, body).transpose();
  const Vector3d from = m.origin(home, body), to = m.origin(pose, body);
  for (Solid& s : plate.solids) {
    s.a = to + turn * (s.a - from), s.b = to + turn * (s.b - from);
    for (Vector3d& p : s.outline) p = to + turn * (p - from);
    scene.solids.push_back(std::move(s));
  }
}

// The joint of a limb's body that is farthest from slide j: where the tube, or the rod, is held.
std::optional<int> far_joint(const Machine& m, const Topology& t, int body, int slide) {
  std::optional<int> best;
  double most = -1;
  for (const int k : joints_of(t, body)) {
    const double d = (m.centre(m.home_pose(), k) - m.centre(m.home_pose(), slide)).norm();
    if (k != slide && d > most) most = d, best = k;
  }
  return best;
}

// A telescopic limb whose parts declare no shapes: the tube from one end, the rod from the other, each a fixed share of the length at home.
bool add_telescope(Scene& scene, const Machine& m, const Pose& pose, const Sizes& sizes, int body) {
  const Topology& t = m.topology();
  for (const int j : joints_of(t, body)) {
    const Joint& slide = joint(t, j);
    const bool slides = slide.kind == JointKind::prismatic || slide.kind == JointKind::cylindrical;
    const int other = slide.a == body ? slide.b : slide.a;
    if (!slides || other == 0 || other == t.platform) continue;
    const auto mine = far_joint(m, t, body, j), theirs = far_joint(m, t, other, j);
    if (!mine || !theirs) continue;
    const Vector3d axis = m.axis(pose, j);
    const Vector3d a = m.centre(pose, *mine), span = m.centre(pose, *theirs) - a;
    const double home_length = (m.centre(m.home_pose(), *theirs) - m.centre(m.home_pose(), *mine)).norm();
    if (span.cross(axis).norm() > 0.05 * span.norm() || home_length < sizes.joint) continue;
    const bool tube = slide.a == body;
    scene.solids.push_back(cylinder(a, a + tube_share * home_length * span.normalized(), (tube ? 0.62 : 0.36) * sizes.joint,
                                    tube ? palette::tube : palette::rod));
    return true;
  }
  return false;
}

// Any other body: a rod between two joints, spokes between more, a carriage where it slides on the base.
void add_links(Scene& scene, const Machine& m, const Pose& pose, const Sizes& sizes, int body) {
  const Topology& t = m.topology();
  std::vector<Vector3d> points;
  Vector3d middle = Vector3d::Zero();
  for (const int j : joints_of(t, body)) {
    const Vector3d c = m.centre(pose, j);
    const Joint& k = joint(t, j);
    if (k.kind == JointKind::prismatic && (k.a == 0 || k.b == 0)) {
      const double half = 1.05 * radius(sizes, j);
      const Vector3d z = m.axis(pose, j), x = z.unitOrthogonal();
      Matrix3d axes;
      axes << x, z.cross(x), z;
      scene.solids.push_back({Solid::Kind::box, c, {half, half, 1.25 * half}, 0, axes, {}, palette::tube, 0});
    }
    if (std::none_of(points.begin(), points.end(), [&](const Vector3d& p) { return (p - c).norm() < 0.3 * sizes.joint; }))
      points.push_back(c);
  }
  const double r = 0.45 * sizes.joint;
  if (points.size() == 2) scene.solids.push_back(cylinder(points[0], points[1], r, palette::rod));
  if (points.size() < 3) return;
  for (const Vector3d& p : points) middle += p / static_cast<double>(points.size());
  for (const Vector3d& p : points) scene.solids.push_back(cylinder(middle, p, r, palette::rod));
  scene.solids.push_back(ball(middle, 1.3 * r, palette::rod));
}

}  // namespace

void add_bodies(Scene& scene, const Machine& m, const Pose& pose, const Sizes& sizes) {
  const Topology& t = m.topology();
  const std::vector<Drive> drives = drives_of_bodies(t);
  for (int body = 0; body < static_cast<int>(t.bodies.size()); ++body) {
    const bool base = body == 0, platform = body == t.platform;
    const std::size_t first = scene.solids.size();
    if (has_shapes(t, body))
      add_shapes(scene, m, pose, body, base ? palette::base : platform ? palette::platform : limb_color(t, body));
    else if (base || platform)
      add_plate(scene, m, pose, sizes, body, (base ? base_thickness : platform_thickness) * sizes.overall,
                base ? palette::base : palette::platform);
    else if (!add_telescope(scene, m, pose, sizes, body))
      add_links(scene, m, pose, sizes, body);
    for (std::size_t k = first; k < scene.solids.size(); ++k) {
      Solid& s = scene.solids[k];
      s.body = body;
      s.color = tinted(s.color, drives[static_cast<std::size_t>(body)]);
    }
  }
}

}  // namespace pmreport::scene
