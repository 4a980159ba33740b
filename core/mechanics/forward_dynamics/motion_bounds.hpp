// What a motion must keep within: strokes, joint limits, and the side of the singular surface on which it began.
#pragma once

#include <core/mechanics/model/closure.hpp>
#include <core/mechanics/model/outcome.hpp>

#include <optional>

namespace pmreport::mechanics {

class MotionBounds {
 public:
  explicit MotionBounds(const Machine& machine);

  // How far a pose is from each bound: of lengths [m], of angles [rad], of the singular surface det G over its size at home. Negative
  // beyond it; limits that are met exactly are kept. Nothing where the pose cannot be assembled.
  std::optional<Eigen::VectorXd> margins(const SmallVector& q) const;

  // The motion begins at `q`. Throws MechanismError when that is no place to begin.
  void begin(const SmallVector& q);

  Outcome outcome(Eigen::Index bound) const;  // of a motion that meets it: at_limit, or singular
  // What has the bound, "rho3 (length of leg 3)", and what bounds it, "the upper end of its stroke, 1410 mm"; of strokes and joints alone.
  std::string subject(Eigen::Index bound) const;
  std::string edge(Eigen::Index bound) const;

 private:
  struct Bound {
    int actuator = -1, joint = -1;  // or neither: the singular surface
    std::size_t part = 0;           // of the joint's limits
    bool upper = false;
    double limit = 0;  // [m] or [rad]
  };
  const Bound& at(Eigen::Index bound) const { return bounds_[static_cast<std::size_t>(bound)]; }
  Sense sense(const Bound& b) const;
  double determinant(const Pose& pose) const;

  const Machine& machine_;
  Closure closure_;
  std::vector<Bound> bounds_;
  double determinant_ = 0;  // at home; with the sign of the start
};

}  // namespace pmreport::mechanics
