#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector3d;

constexpr float seen_through = 0.35f;

void add_arrow(Scene& scene, const Vector3d& tail, const Vector3d& tip, double radius, const Color& color) {
  const Vector3d along = (tip - tail).normalized();
  const double length = (tip - tail).norm(), head = std::min(5.5 * radius, 0.5 * length);
  scene.solids.push_back(cylinder(tail, tip - 0.95 * head * along, radius, color, seen_through));
  scene.solids.push_back(cone(tip - head * along, tip, 2.3 * radius, color, seen_through));
}

// Three quarters of a turn about `axis`, right-handed, ending in a head.
void add_turn(Scene& scene, const Vector3d& centre, const Vector3d& axis, double ring, double radius, const Color& color) {
  constexpr int pieces = 36;
  const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
  const double head = 5.5 * radius / ring, sweep = 1.6 * std::numbers::pi - head;
  const auto at = [&](double angle) { return Vector3d(centre + ring * (std::cos(angle) * u + std::sin(angle) * v)); };
  for (int k = 0; k < pieces; ++k) {
    // Pieces reach a little into the next: no gap opens at the bends.
    scene.solids.push_back(cylinder(at(sweep * k / pieces), at(sweep * (k + 1.15) / pieces), radius, color, seen_through));
  }
  const Vector3d base = at(sweep), along = (-std::sin(sweep + head / 2) * u + std::cos(sweep + head / 2) * v);
  scene.solids.push_back(cone(base, base + head * ring * along, 2.3 * radius, color, seen_through));
}

}  // namespace

void add_frame(Scene& scene, const Vector3d& origin, const Eigen::Matrix3d& axes, const char* const names[4], double length) {
  const double r = 0.022 * length;
  const Color colors[] = {palette::x, palette::y, palette::z};
  scene.solids.push_back(ball(origin, 1.9 * r, palette::ink, seen_through));
  for (int k = 0; k < 3; ++k) {
    const Vector3d tip = origin + length * axes.col(k);
    add_arrow(scene, origin, tip, r, colors[k]);
    scene.labels.push_back({tip + 0.10 * length * axes.col(k), names[k + 1], colors[k]});
  }
  scene.labels.push_back({origin, names[0], palette::ink});
}

// A force stands on the platform's outer side, away from the limbs: it begins at the reference point when it pulls there, and ends there
// when it pushes. A moment turns about the same point, farther out along its axis.
void add_extras(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const Sizes& sizes, const Extras& extras) {
  const Topology& t = machine.topology();
  const Vector3d p = machine.origin(pose, t.platform);
  Vector3d outer = Vector3d::Zero();
  for (std::size_t k = 0; k < t.joints.size(); ++k) outer += p - machine.centre(pose, static_cast<int>(k));
  if (extras.path.size() > 1) {
    scene.lines.push_back({extras.path, palette::path, 2.4, 0.5f});
    scene.solids.push_back(ball(p, 0.42 * sizes.joint, palette::path, 0.8f));
  }
  const double length = 0.25 * sizes.overall, r = 0.0075 * sizes.overall;
  if (extras.force.norm() > 0) {
    const Vector3d along = extras.force.normalized();
    const bool pulls = along.dot(outer) >= 0;
    const Vector3d tail = pulls ? p : Vector3d(p - length * along);
    add_arrow(scene, tail, tail + length * along, r, palette::load);
    scene.labels.push_back({pulls ? Vector3d(p + 1.12 * length * along) : Vector3d(p - 1.10 * length * along), "F", palette::load});
  }
  if (extras.moment.norm() > 0) {
    const Vector3d axis = extras.moment.normalized(), out = axis.dot(outer) >= 0 ? axis : Vector3d(-axis);
    const Vector3d centre = p + 0.62 * length * out;
    scene.lines.push_back({{p, centre + 0.18 * length * out}, palette::load, 1.4, seen_through});
    add_turn(scene, centre, axis, 0.24 * length, 0.8 * r, palette::load);
    scene.labels.push_back({centre + 0.38 * length * out, "M", palette::load});
  }
}

}  // namespace pmreport::scene
