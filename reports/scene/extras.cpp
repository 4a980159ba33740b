#include <Eigen/Geometry>
#include <cmath>
#include <core/text/units.hpp>
#include <numbers>
#include <reports/scene/look.hpp>

namespace pmreport::scene {

namespace {

using Eigen::Vector3d;

constexpr float seen_through = 0.35f;

void add_arrow(Scene& scene, const Vector3d& tail, const Vector3d& tip, double radius, const Color& color, float hidden = seen_through) {
  const Vector3d along = (tip - tail).normalized();
  const double length = (tip - tail).norm(), head = std::min(5.5 * radius, 0.5 * length);
  scene.solids.push_back(cylinder(tail, tip - 0.95 * head * along, radius, color, hidden));
  scene.solids.push_back(cone(tip - head * along, tip, 2.3 * radius, color, hidden));
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

constexpr double screw_half = 0.60;  // of the overall size: half the line that is drawn of a screw's axis

constexpr double far_off = 1.5;  // of the overall size: a picture that held an axis farther away would show a small machine

// Where the axis comes nearest to the platform; of a free one, the platform itself.
Vector3d middle_of(const Screw& screw, const Vector3d& platform) {
  if (std::isinf(screw.pitch)) return platform;
  return screw.point + screw.direction.dot(platform - screw.point) * screw.direction;
}

bool is_far(const Vector3d& middle, const Vector3d& platform, const Sizes& sizes) {
  return (middle - platform).norm() > far_off * sizes.overall;
}

// A turn about a far axis moves the platform almost straight: an arrow along that motion stands for it, and another, at the end of a line,
// tells where the axis is and how far.
void add_far_screw(Scene& scene, const Screw& screw, const Vector3d& platform, const Vector3d& middle, const Sizes& sizes) {
  const double r = 0.011 * sizes.overall, distance = (middle - platform).norm();
  const Vector3d towards = (middle - platform) / distance;
  const Vector3d motion = (screw.direction.cross(platform - middle) + screw.pitch * screw.direction).normalized();
  add_arrow(scene, platform, platform + 0.34 * sizes.overall * motion, r, screw.color);
  scene.labels.push_back({platform + 0.38 * sizes.overall * motion, screw.label, screw.color, 0});
  const Vector3d tip = platform + screw_half * sizes.overall * towards;
  add_arrow(scene, platform, tip, 0.45 * r, screw.color);
  scene.labels.push_back({tip + 0.04 * sizes.overall * towards, "axis " + format_number(distance, 3) + " m away", screw.color, 0});
}

// A long line that is seen through everything; the arrows along and around stand on it beside the platform, on the side that `outer` points
// to.
void add_screw(Scene& scene, const Screw& screw, const Vector3d& platform, const Vector3d& outer, const Sizes& sizes) {
  const double half = screw_half * sizes.overall, r = 0.011 * sizes.overall;
  const Vector3d d = screw.direction.dot(outer) < 0 ? Vector3d(-screw.direction) : screw.direction;
  const bool free = std::isinf(screw.pitch);
  const Vector3d middle = middle_of(screw, platform);
  if (is_far(middle, platform, sizes)) return add_far_screw(scene, screw, platform, middle, sizes);
  const Vector3d end = middle + half * d;
  scene.solids.push_back(cylinder(middle - half * d, end, 0.45 * r, screw.color, 0.75f));
  if (screw.pitch != 0) {
    const double length = 0.24 * sizes.overall;
    const Vector3d low = middle + (free ? 0.35 : 0.50) * half * d, high = low + length * d;
    screw.pitch > 0 ? add_arrow(scene, low, high, r, screw.color) : add_arrow(scene, high, low, r, screw.color);
  }
  if (!free) add_turn(scene, middle + 0.38 * half * d, d, 0.10 * sizes.overall, r, screw.color);
  scene.labels.push_back({end + 0.04 * sizes.overall * d, screw.label, screw.color, 0});
}

// Each begins at the centre of its joint, so that arrows of one scale compare; the platform's own load is drawn by the same scale. Many lie
// within their limbs: one colour that no limb has, and that limbs hardly hide.
void add_joint_forces(Scene& scene, const mechanics::Machine& machine, const mechanics::Pose& pose, const Sizes& sizes,
                      const Extras& extras) {
  constexpr float hardly_hidden = 0.8f;
  for (const JointForce& f : extras.joint_forces) {
    if (!(f.force.norm() > 0) || !(extras.full_force > 0)) continue;
    const Vector3d at = machine.centre(pose, f.joint), along = f.force.normalized();
    const double length = longest_force * sizes.overall * std::min(1.0, f.force.norm() / extras.full_force);
    add_arrow(scene, at, at + length * along, 0.0065 * sizes.overall, palette::reaction, hardly_hidden);
    if (!f.label.empty()) scene.labels.push_back({at + (length + 0.03 * sizes.overall) * along, f.label, palette::reaction, 0});
  }
}

}  // namespace

void include(Bounds& bounds, const mechanics::Machine& machine, const mechanics::Pose& pose, const Screw& screw) {
  const Sizes sizes = measure(machine);
  const Vector3d platform = machine.origin(pose, machine.topology().platform), middle = middle_of(screw, platform);
  const double half = screw_half * sizes.overall, rim = 0.06 * sizes.overall;
  if (is_far(middle, platform, sizes)) return bounds.include(platform + half * (middle - platform).normalized(), rim);
  for (const double side : {-1.0, 1.0}) bounds.include(middle + side * half * screw.direction, rim);
}

void add_frame(Scene& scene, const Vector3d& origin, const Eigen::Matrix3d& axes, const char* const names[4], double length) {
  const double r = 0.022 * length;
  const Color colors[] = {palette::x, palette::y, palette::z};
  scene.solids.push_back(ball(origin, 1.9 * r, palette::ink, seen_through));
  for (int k = 0; k < 3; ++k) {
    const Vector3d tip = origin + length * axes.col(k);
    add_arrow(scene, origin, tip, r, colors[k]);
    scene.labels.push_back({tip + 0.10 * length * axes.col(k), names[k + 1], colors[k], 0});
  }
  scene.labels.push_back({origin, names[0], palette::ink, 0});
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
  const double r = 0.0075 * sizes.overall;
  if (extras.force.norm() > 0) {
    const Vector3d along = extras.force.normalized();
    const double length =
        longest_force * sizes.overall * (extras.full_force > 0 ? std::min(1.0, extras.force.norm() / extras.full_force) : 1);
    const bool pulls = along.dot(outer) >= 0;
    const Vector3d tail = pulls ? p : Vector3d(p - length * along);
    add_arrow(scene, tail, tail + length * along, r, palette::load);
    const double beyond = length + 0.03 * sizes.overall;
    scene.labels.push_back({pulls ? Vector3d(p + beyond * along) : Vector3d(p - beyond * along), extras.force_label, palette::load, 0});
  }
  if (extras.moment.norm() > 0) {
    const Vector3d axis = extras.moment.normalized(), out = axis.dot(outer) >= 0 ? axis : Vector3d(-axis);
    const Vector3d centre = p + 0.155 * sizes.overall * out;
    const double share = extras.full_moment > 0 ? std::min(1.0, extras.moment.norm() / extras.full_moment) : 1;
    scene.lines.push_back({{p, centre + 0.045 * sizes.overall * out}, palette::load, 1.4, seen_through});
    add_turn(scene, centre, axis, (0.025 + 0.035 * share) * sizes.overall, 0.8 * r, palette::load);
    scene.labels.push_back({centre + 0.095 * sizes.overall * out, extras.moment_label, palette::load, 0});
  }
  add_joint_forces(scene, machine, pose, sizes, extras);
  for (const Screw& screw : extras.screws) add_screw(scene, screw, p, outer, sizes);
}

}  // namespace pmreport::scene
