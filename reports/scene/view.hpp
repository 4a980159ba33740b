// Where a camera sees a point: the one place that knows azimuth, elevation and scale.
#pragma once

#include <reports/scene/scene.hpp>

namespace pmreport::scene {

// Orthographic: x right and y down [px] from the top left corner of the picture, depth towards the viewer [px].
class View {
 public:
  View(const Camera& camera, int width, int height);
  Eigen::Vector3d see(const Eigen::Vector3d& point) const;       // [m] -> [px]
  Eigen::Vector3d turn(const Eigen::Vector3d& direction) const;  // to axes right, up, towards the viewer; keeps its length
  Eigen::Vector3d world(const Eigen::Vector3d& seen) const;      // [px] -> [m]
  Eigen::Vector3d right() const { return axes_.row(0); }
  Eigen::Vector3d up() const { return axes_.row(1); }
  Eigen::Vector3d towards() const { return axes_.row(2); }
  double scale() const { return scale_; }  // [px/m]

 private:
  Eigen::Matrix3d axes_;  // rows: right, up, towards the viewer; base axes
  Eigen::Vector3d target_;
  double scale_;
  Eigen::Vector2d middle_;
};

}  // namespace pmreport::scene
