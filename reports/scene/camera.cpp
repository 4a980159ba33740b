#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <reports/scene/view.hpp>

namespace pmreport::scene {

namespace {

// The camera looks along f = (-sin a cos e, cos a cos e, -sin e): along +Y at azimuth 0, along -X at 90°, straight down at elevation 90°.
// Right is horizontal at every elevation, so that the vertical of the machine stays vertical in the picture, and is defined in a view from
// above as well, where up would not be.
Eigen::Matrix3d axes_of_view(double azimuth, double elevation) {
  const double sa = std::sin(azimuth), ca = std::cos(azimuth), se = std::sin(elevation), ce = std::cos(elevation);
  Eigen::Matrix3d axes;
  axes << ca, sa, 0,          //
      -sa * se, ca * se, ce,  //
      sa * ce, -ca * ce, se;
  return axes;
}

}  // namespace

View::View(const Camera& camera, int width, int height)
    : axes_(axes_of_view(camera.azimuth, camera.elevation)),
      target_(camera.target),
      scale_(height / camera.height),
      middle_(width / 2.0, height / 2.0) {}

Eigen::Vector3d View::see(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d v = scale_ * (axes_ * (point - target_));
  return {middle_.x() + v.x(), middle_.y() - v.y(), v.z()};
}

Eigen::Vector3d View::turn(const Eigen::Vector3d& direction) const { return axes_ * direction; }

Eigen::Vector3d View::world(const Eigen::Vector3d& seen) const {
  return target_ + axes_.transpose() * Eigen::Vector3d(seen.x() - middle_.x(), middle_.y() - seen.y(), seen.z()) / scale_;
}

Eigen::Vector2d project(const Camera& camera, const Eigen::Vector3d& point, int width, int height) {
  return View(camera, width, height).see(point).head<2>();
}

namespace {

// Directions spread over the sphere along a spiral, about 18 degrees apart. What reaches farthest in any direction is then known to 1.3 %
// of its distance, well within a picture's margin; a box alone would leave a third of an isometric picture empty.
const std::vector<Eigen::Vector3d>& directions() {
  static const std::vector<Eigen::Vector3d> all = [] {
    constexpr int count = 128;
    const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
    std::vector<Eigen::Vector3d> d;
    for (int k = 0; k < count; ++k) {
      const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z);
      d.emplace_back(r * std::cos(golden_angle * k), r * std::sin(golden_angle * k), z);
    }
    return d;
  }();
  return all;
}

}  // namespace

void Bounds::include(const Eigen::Vector3d& p, double margin) {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(margin);
  low = empty ? Eigen::Vector3d(p - reach) : Eigen::Vector3d(low.cwiseMin(p - reach));
  high = empty ? Eigen::Vector3d(p + reach) : Eigen::Vector3d(high.cwiseMax(p + reach));
  const std::vector<Eigen::Vector3d>& d = directions();
  if (empty)
    for (const Eigen::Vector3d& u : d) extremes.emplace_back(p + margin * u);
  for (std::size_t k = 0; k < d.size(); ++k)
    if (d[k].dot(p) + margin > d[k].dot(extremes[k])) extremes[k] = p + margin * d[k];
  empty = false;
}

// The window holds the extreme points and a margin of 7 % on every side.
Camera frame(const Bounds& bounds, double azimuth, double elevation, double aspect) {
  constexpr double margin = 0.07;
  Camera camera;
  camera.azimuth = azimuth;
  camera.elevation = elevation;
  if (bounds.empty) return camera;
  const Eigen::Matrix3d axes = axes_of_view(azimuth, elevation);
  Eigen::Vector3d low = axes * bounds.extremes.front(), high = low;
  for (const Eigen::Vector3d& p : bounds.extremes) low = low.cwiseMin(axes * p), high = high.cwiseMax(axes * p);
  const Eigen::Vector3d span = high - low;
  camera.target = axes.transpose() * ((low + high) / 2);
  const double height = std::max(span.y(), span.x() / aspect) / (1 - 2 * margin);
  camera.height = height > 0 ? height : 1;
  return camera;
}

}  // namespace pmreport::scene
