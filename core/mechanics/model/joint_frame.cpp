#include <core/mechanics/model/joint_frame.hpp>

#include <Eigen/Geometry>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;

JointFrames::JointFrames(const Machine& machine) {
  const Topology& t = machine.topology();
  const auto slender = [&](int body) { return t.bodies[static_cast<std::size_t>(body)].slender; };
  for (std::size_t j = 0; j < t.joints.size(); ++j) {
    const Joint& joint = t.joints[j];
    Recipe r;
    if (joint.kind == JointKind::spherical) r.stud = joint.stud;
    r.second_axis = joint.kind == JointKind::universal;
    r.carrier = joint.stud >= 0 && joint.kind == JointKind::spherical ? joint.stud : joint.a;
    if (slender(r.carrier)) r.carrier = r.carrier == joint.a ? joint.b : joint.a;
    if (slender(r.carrier)) r.carrier = 0;
    const Vector3d along = r.stud >= 0 ? Vector3d(machine.rotation(machine.home_pose(), r.stud).col(2))
                                       : machine.axis(machine.home_pose(), static_cast<int>(j));
    Eigen::Index across;
    along.cwiseAbs().minCoeff(&across);
    r.mark = machine.rotation(machine.home_pose(), r.carrier).transpose() * Vector3d::Unit(across);
    recipes_.push_back(r);
  }
}

Matrix3d JointFrames::operator()(const State& state, int joint) const {
  const Recipe& r = recipe(joint);
  const JointState& at = state.joints[static_cast<std::size_t>(joint)];
  Matrix3d f;
  f.col(0) = r.stud >= 0 ? Vector3d(state.bodies[static_cast<std::size_t>(r.stud)].rotation.col(2)) : at.axis[0];
  const Vector3d second = r.second_axis ? at.axis[1] : state.bodies[static_cast<std::size_t>(r.carrier)].rotation * r.mark;
  f.col(2) = f.col(0).cross(second).normalized();
  f.col(1) = f.col(2).cross(f.col(0));
  return f;
}

}  // namespace pmreport::mechanics
