#include <core/mechanics/model/closure.hpp>

#include <Eigen/Geometry>
#include <cmath>
#include <core/assertion.hpp>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

double angle_between(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

std::vector<BodyState> bodies_at_rest(const Machine& machine, const Pose& pose) {
  PMREPORT_ASSERT(pose.status == PM_OK, "the pose is assembled");
  std::vector<BodyState> bodies(machine.topology().bodies.size());
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    bodies[i].origin = machine.origin(pose, static_cast<int>(i));
    bodies[i].rotation = machine.rotation(pose, static_cast<int>(i));
  }
  return bodies;
}

Closure::Closure(const Machine& machine) : machine_(machine) {
  const std::vector<BodyState> bodies = bodies_at_rest(machine, machine.home_pose());
  const auto& joints = machine.topology().joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& j = joints[i];
    const BodyState &a = bodies[static_cast<std::size_t>(j.a)], &b = bodies[static_cast<std::size_t>(j.b)];
    const auto seat = [&](const BodyState& body) {
      JointSeat s{body.rotation.transpose() * (machine.centre(machine.home_pose(), static_cast<int>(i)) - body.origin), {}};
      for (int k = 0; k < axes_of(j.kind); ++k)
        s.axis[k] = body.rotation.transpose() * machine.axis(machine.home_pose(), static_cast<int>(i), k);
      return s;
    };
    JointHome h{seat(a), seat(b), a.rotation.transpose() * b.rotation, Vector3d::Zero()};
    if (j.kind == JointKind::spherical) {
      const bool stud_is_a = j.stud == j.a;
      h.stud = j.from.isZero() ? Vector3d((stud_is_a ? b : a).rotation.transpose() * (stud_is_a ? a : b).rotation.col(2))
                               : Vector3d(j.from.normalized());
    }
    home_.push_back(h);
  }
}

ClosureError Closure::error(const std::vector<BodyState>& bodies) const {
  PMREPORT_ASSERT(bodies.size() == machine_.topology().bodies.size(), "all bodies are given, base first");
  ClosureError e;
  const Topology& t = machine_.topology();
  for (std::size_t i = 0; i < home_.size(); ++i) {
    const Joint& j = t.joints[i];
    const JointHome& h = home_[i];
    const BodyState &a = bodies[static_cast<std::size_t>(j.a)], &b = bodies[static_cast<std::size_t>(j.b)];
    Vector3d gap = b.origin + b.rotation * h.b.centre - a.origin - a.rotation * h.a.centre;  // (1)
    const Vector3d axis_a = a.rotation * h.a.axis[0];
    double turn = 0;  // (2)
    switch (j.kind) {
      case JointKind::spherical:
        break;
      case JointKind::revolute:
        turn = angle_between(axis_a, b.rotation * h.b.axis[0]);
        break;
      case JointKind::universal:
        turn = std::abs(std::asin(std::clamp(axis_a.dot(b.rotation * h.b.axis[1]), -1.0, 1.0)));
        break;
      case JointKind::cylindrical:
      case JointKind::prismatic: {
        gap -= axis_a * axis_a.dot(gap);
        const bool spinning = t.bodies[static_cast<std::size_t>(j.a)].slender || t.bodies[static_cast<std::size_t>(j.b)].slender;
        if (j.kind == JointKind::prismatic && !spinning) {
          const Matrix3d change = h.relative.transpose() * a.rotation.transpose() * b.rotation;  // R_AB at home and now: 1 when equal
          const Vector3d skew(change(2, 1) - change(1, 2), change(0, 2) - change(2, 0), change(1, 0) - change(0, 1));
          turn = std::atan2(skew.norm(), change.trace() - 1.0);
        } else {
          turn = angle_between(axis_a, b.rotation * h.b.axis[0]);
        }
        break;
      }
    }
    if (!(gap.norm() <= e.gap)) e.gap = gap.norm(), e.gap_joint = static_cast<int>(i);
    if (!(turn <= e.misalignment)) e.misalignment = turn, e.misalignment_joint = static_cast<int>(i);
  }
  return e;
}

std::vector<double> Closure::motion(const std::vector<BodyState>& bodies, int joint) const {
  const Joint& j = machine_.topology().joints[static_cast<std::size_t>(joint)];
  const auto placed = [&](int body) {
    const BodyState& b = bodies[static_cast<std::size_t>(body)];
    return Placed<double>{b.origin, b.rotation};
  };
  return joint_motion(j, home(joint), placed(j.a), placed(j.b));
}

}  // namespace pmreport::mechanics
