#include <core/mechanics/forward_dynamics/motion_bounds.hpp>

#include <core/linear/square.hpp>
#include <core/linear/tolerance.hpp>
#include <core/mechanics/model/joint_motion.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::mechanics {

namespace {

constexpr double met_exactly = 1e-12;  // of a limit, or of one metre or radian: rounding

std::string shown(double value, Sense sense) {
  if (sense == Sense::linear) return fmt::format("{:.6g} mm", 1e3 * value);
  return fmt::format("{:.6g}°", value * 180 / std::numbers::pi);
}

}  // namespace

MotionBounds::MotionBounds(const Machine& machine)
    : machine_(machine), closure_(machine), determinant_(std::abs(determinant(machine.home_pose()))) {
  const Topology& t = machine.topology();
  for (int i = 0; i < machine.dof(); ++i)
    for (const bool upper : {false, true}) {
      const Range& stroke = t.actuators[static_cast<std::size_t>(i)].stroke;
      bounds_.push_back({i, -1, 0, upper, upper ? stroke.max : stroke.min});
    }
  for (std::size_t j = 0; j < t.joints.size(); ++j)
    for (std::size_t part = 0; part < t.joints[j].limits.size(); ++part)
      for (const bool upper : {false, true}) {
        const Range& range = t.joints[j].limits[part];
        if (binds(t.joints[j], range, upper)) bounds_.push_back({-1, static_cast<int>(j), part, upper, upper ? range.max : range.min});
      }
  bounds_.push_back({});
}

double MotionBounds::determinant(const Pose& pose) const {
  const Jacobian g = machine_.jacobian(pose);
  return g.known() ? linear::determinant(g.matrix) : 0;  // it has no value on some singular surfaces
}

std::optional<Eigen::VectorXd> MotionBounds::margins(const SmallVector& q) const {
  const Pose pose = machine_.pose({q.data(), static_cast<std::size_t>(q.size())});
  if (pose.status == PM_UNREACHABLE || pose.status == PM_SINGULAR) return std::nullopt;
  if (pose.status != PM_OK) throw MechanismError(PM_FAILED, pose.why);
  const std::vector<BodyState> bodies = bodies_at_rest(machine_, pose);
  Eigen::VectorXd out(static_cast<Eigen::Index>(bounds_.size()));
  int joint = -1;
  std::vector<double> motion;
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    const Bound& b = bounds_[i];
    double& margin = out(static_cast<Eigen::Index>(i));
    if (b.actuator < 0 && b.joint < 0) {
      margin = determinant(pose) / determinant_ - linear::vanished_determinant;
      continue;
    }
    if (b.joint >= 0 && b.joint != joint) motion = closure_.motion(bodies, joint = b.joint);
    const double value = b.joint >= 0 ? motion[b.part] : pose.numbers[machine_.layout().actuator(b.actuator)];
    margin = (b.upper ? b.limit - value : value - b.limit) + met_exactly * std::max(1.0, std::abs(b.limit));
  }
  return out;
}

void MotionBounds::begin(const SmallVector& q) {
  const Pose pose = machine_.pose({q.data(), static_cast<std::size_t>(q.size())});
  if (pose.status == PM_UNREACHABLE || pose.status == PM_SINGULAR)
    throw MechanismError(PM_BAD_ARGUMENT, "the mechanism cannot be assembled there" + (pose.why.empty() ? "" : ": " + pose.why));
  if (pose.status != PM_OK) throw MechanismError(PM_FAILED, pose.why);
  if (std::signbit(determinant(pose)) != std::signbit(determinant_)) determinant_ = -determinant_;
  const Eigen::VectorXd here = *margins(q);
  Eigen::Index worst = 0;
  if (here.minCoeff(&worst) >= 0) return;
  if (outcome(worst) == Outcome::singular)
    throw MechanismError(PM_BAD_ARGUMENT, "the pose is singular: the actuators do not hold the platform");
  throw MechanismError(PM_BAD_ARGUMENT,
                       fmt::format("{} is {} beyond {}", subject(worst), shown(-here(worst), sense(at(worst))), edge(worst)));
}

Outcome MotionBounds::outcome(Eigen::Index bound) const {
  return at(bound).actuator < 0 && at(bound).joint < 0 ? Outcome::singular : Outcome::at_limit;
}

Sense MotionBounds::sense(const Bound& b) const {
  const Topology& t = machine_.topology();
  if (b.actuator >= 0) return t.actuators[static_cast<std::size_t>(b.actuator)].sense();
  return b.joint >= 0 && t.joints[static_cast<std::size_t>(b.joint)].kind == JointKind::prismatic ? Sense::linear : Sense::rotary;
}

std::string MotionBounds::subject(Eigen::Index bound) const {
  const Topology& t = machine_.topology();
  if (at(bound).actuator < 0) return "joint " + t.joints[static_cast<std::size_t>(at(bound).joint)].name;
  const Actuator& a = t.actuators[static_cast<std::size_t>(at(bound).actuator)];
  return a.name + " (" + a.title + ")";
}

std::string MotionBounds::edge(Eigen::Index bound) const {
  const Bound& b = at(bound);
  const std::string limit = shown(b.limit, sense(b));
  if (b.actuator >= 0) return fmt::format("the {} end of its stroke, {}", b.upper ? "upper" : "lower", limit);
  const bool two_axes = machine_.topology().joints[static_cast<std::size_t>(b.joint)].limits.size() > 1;
  return fmt::format("its limit{}, {}", !two_axes ? "" : b.part == 0 ? " about its first axis" : " about its second axis", limit);
}

}  // namespace pmreport::mechanics
