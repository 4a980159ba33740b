#include <tests/judges/simbody_system.hpp>

#include <Eigen/Geometry>

namespace pmreport::judges {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using SimTK::MobilizedBody;
using SimTK::Transform;
using SimTK::Vec3;

SimTK::Rotation rotation(const Matrix3d& r) {
  return {SimTK::Mat33(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)), true};
}

SimbodySystem::SimbodySystem(const mechanics::Machine& machine)
    : machine_(machine), t_(machine.topology()), tree_(spanning_tree(t_)), constraints_(t_.joints.size()) {
  matter.setShowDefaultGeometry(false);
  mobods_.resize(t_.bodies.size());
  mobods_[0] = matter.Ground();
  home_.resize(t_.bodies.size());
  for (int b = 1; b < static_cast<int>(t_.bodies.size()); ++b)
    home_[static_cast<std::size_t>(b)] =
        Transform(rotation(machine.rotation(machine.home_pose(), b)), vec(machine.origin(machine.home_pose(), b)));
  for (const int j : tree_.outward) add_mobilizer(j);
  for (std::size_t j = 0; j < t_.joints.size(); ++j)
    if (tree_.parent[j] == SpanningTree::left_out) add_constraints(static_cast<int>(j));
}

int SimbodySystem::child(int j) const {
  const Joint& joint = t_.joints[static_cast<std::size_t>(j)];
  return joint.a == tree_.parent[static_cast<std::size_t>(j)] ? joint.b : joint.a;
}

Vector3d SimbodySystem::axis_at_home(int j, int k) const { return machine_.axis(machine_.home_pose(), j, k); }
Vec3 SimbodySystem::centre_at_home(int j) const { return vec(machine_.centre(machine_.home_pose(), j)); }
SimTK::UnitVec3 SimbodySystem::direction(int b, const Vector3d& in_base) const { return SimTK::UnitVec3(~home(b).R() * vec(in_base)); }

// Simbody refuses moments of inertia that break the triangle inequality, as where a body hinged to the base carries that of a geared
// rotor about its axis. Such a body turns about that axis n alone, so what is added here, a multiple of 1 - n n', has no part in its
// momentum.
SimTK::Body::Rigid SimbodySystem::rigid(int j) const {
  const int b = child(j);
  const Inertia& i = t_.bodies[static_cast<std::size_t>(b)].inertia;
  Matrix3d about_origin = i.about_centre + i.mass * (i.centre.squaredNorm() * Matrix3d::Identity() - i.centre * i.centre.transpose());
  if (tree_.parent[static_cast<std::size_t>(j)] == 0 && t_.joints[static_cast<std::size_t>(j)].kind == JointKind::revolute) {
    const Vector3d n = machine_.rotation(machine_.home_pose(), b).transpose() * axis_at_home(j);
    about_origin += n.dot(i.about_centre * n) * (Matrix3d::Identity() - n * n.transpose());
  }
  const SimTK::Inertia inertia(SimTK::SymMat33(about_origin(0, 0), about_origin(1, 0), about_origin(1, 1), about_origin(2, 0),
                                               about_origin(2, 1), about_origin(2, 2)));
  return SimTK::Body::Rigid(SimTK::MassProperties(i.mass, vec(i.centre), inertia));
}

// Simbody turns about z, slides along x, and turns a universal joint about x of the parent and y of the child. What the child does
// relative to the parent is told of body b relative to body a, so the axis is reversed where they change places.
void SimbodySystem::add_mobilizer(int j) {
  const Joint& joint = t_.joints[static_cast<std::size_t>(j)];
  const int p = tree_.parent[static_cast<std::size_t>(j)], b = child(j);
  const bool reversed = joint.a != p;
  const auto along = [&](int k) { return SimTK::UnitVec3(vec(reversed ? Vector3d(-axis_at_home(j, k)) : axis_at_home(j, k))); };
  SimTK::Rotation axes;
  if (joint.kind == JointKind::prismatic)
    axes = SimTK::Rotation(along(0), SimTK::XAxis);
  else if (joint.kind == JointKind::revolute || joint.kind == JointKind::cylindrical)
    axes = SimTK::Rotation(along(0), SimTK::ZAxis);
  else if (joint.kind == JointKind::universal)
    axes = SimTK::Rotation(along(reversed ? 1 : 0), SimTK::XAxis, Vec3(along(reversed ? 0 : 1)), SimTK::YAxis);
  const Transform frame(axes, centre_at_home(j)), inboard = ~home(p) * frame, outboard = ~home(b) * frame;
  const SimTK::Body::Rigid body_of_child = rigid(j);
  switch (joint.kind) {
    case JointKind::revolute:
      body(b) = MobilizedBody::Pin(body(p), inboard, body_of_child, outboard);
      break;
    case JointKind::prismatic:
      body(b) = MobilizedBody::Slider(body(p), inboard, body_of_child, outboard);
      break;
    case JointKind::universal:
      body(b) = MobilizedBody::Universal(body(p), inboard, body_of_child, outboard);
      break;
    case JointKind::spherical:
      body(b) = MobilizedBody::Ball(body(p), inboard, body_of_child, outboard);
      break;
    case JointKind::cylindrical:
      body(b) = MobilizedBody::Cylinder(body(p), inboard, body_of_child, outboard);
      break;
  }
}

void SimbodySystem::add_constraints(int j) {
  const Joint& joint = t_.joints[static_cast<std::size_t>(j)];
  MobilizedBody &a = body(joint.a), &b = body(joint.b);
  std::vector<SimTK::Constraint>& list = constraints_[static_cast<std::size_t>(j)];
  const Vec3 in_a = ~home(joint.a) * centre_at_home(j);
  const Vec3 in_b = ~home(joint.b) * centre_at_home(j);
  const auto same_point = [&] { list.push_back(SimTK::Constraint::Ball(a, in_a, b, in_b)); };
  const auto square = [&](const Vector3d& of_a, const Vector3d& of_b) {
    list.push_back(SimTK::Constraint::ConstantAngle(a, direction(joint.a, of_a), b, direction(joint.b, of_b)));
  };
  const auto on_line = [&](const Matrix3d& across) {
    for (const int k : {0, 1}) {
      const SimTK::UnitVec3 normal = direction(joint.a, across.col(k));
      list.push_back(SimTK::Constraint::PointInPlane(a, normal, ~normal * in_a, b, in_b));
    }
  };
  Matrix3d frame = Matrix3d::Identity();  // 1 and 2 across the axis, 3 along it
  if (axes_of(joint.kind) > 0) {
    const Vector3d axis = axis_at_home(j), x = axis.unitOrthogonal();
    frame << x, axis.cross(x), axis;
  }
  switch (joint.kind) {
    case JointKind::spherical:
      same_point();
      break;
    case JointKind::revolute:
      same_point();
      for (const int k : {0, 1}) square(frame.col(k), frame.col(2));
      break;
    case JointKind::universal:
      same_point();
      square(axis_at_home(j, 0), axis_at_home(j, 1));
      break;
    case JointKind::cylindrical:
      on_line(frame);
      for (const int k : {0, 1}) square(frame.col(k), frame.col(2));
      break;
    case JointKind::prismatic:
      on_line(frame);
      list.push_back(
          SimTK::Constraint::ConstantOrientation(a, ~home(joint.a).R() * rotation(frame), b, ~home(joint.b).R() * rotation(frame)));
      break;
  }
}

}  // namespace pmreport::judges
