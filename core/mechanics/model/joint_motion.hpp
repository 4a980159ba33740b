// How far a joint has moved from home, from where its two bodies are. Written once for every scalar: numbers, and the recording.
#pragma once

#include <pmreport/scalar.hpp>
#include <pmreport/topology.hpp>

#include <vector>

namespace pmreport::mechanics {

struct JointSeat {         // a joint as body X holds it, in the axes of X
  Eigen::Vector3d centre;  // p_XC_X
  Eigen::Vector3d axis[2];
};
struct JointHome {
  JointSeat a, b;
  Eigen::Matrix3d relative;  // R_AB
  Eigen::Vector3d stud;      // spherical: what the deflection of the stud's z axis counts from, in the axes of the socket; unit
};

template <class T>
struct Placed {  // a body, base axes
  Vector3<T> origin;
  Matrix3<T> rotation;
};

// Whether an end of a limit can be met. An angle from half a turn back to half a turn ahead tells nothing apart, a deflection is never less
// than none, and ten metres either way are no limit of a slide: most are judged by the stroke of their actuator.
bool binds(const Joint& joint, const Range& range, bool upper);
// Whether the motion that limit `k` is about is told and judged: of a slide only where the limit binds.
bool is_told(const Joint& joint, std::size_t k);
// Of that motion: "m" or "rad".
const char* motion_unit(const Joint& joint);

// An angle about the unit axis n of one body A, from the direction c of A to a direction w, both seen along n: with c_ the part of c across
// n, n . (c_ x w) = (n x c_) . w, so that
//     angle = atan2((R_A (n x c_)) . w, (R_A c_) . w)
template <class T>
T angle_about(const Matrix3<T>& rotation, const Eigen::Vector3d& axis, const Eigen::Vector3d& from, const Vector3<T>& to) {
  const Eigen::Vector3d across = from - axis * axis.dot(from), beside = axis.cross(across);
  const Vector3<T> cosine = rotation * across, sine = rotation * beside;
  return atan2(T(sine.dot(to)), T(cosine.dot(to)));
}

// One value a limit: rotations and deflections [rad], travel [m]; signs and meaning as in plugin.h.
template <class T>
std::vector<T> joint_motion(const Joint& joint, const JointHome& home, const Placed<T>& a, const Placed<T>& b) {
  const Eigen::Vector3d& axis = home.a.axis[0];
  switch (joint.kind) {
    case JointKind::spherical: {
      const bool stud_is_a = joint.stud == joint.a;
      const Placed<T>&stud = stud_is_a ? a : b, &socket = stud_is_a ? b : a;
      const Vector3<T> before = socket.rotation * home.stud, now = stud.rotation.col(2);
      return {atan2(length(Vector3<T>(before.cross(now))), T(before.dot(now)))};
    }
    case JointKind::revolute:
    case JointKind::cylindrical: {  // a direction of b across the axis, at home and now
      const Eigen::Vector3d across = axis.unitOrthogonal(), carried = home.relative.transpose() * across;
      return {angle_about(a.rotation, axis, across, Vector3<T>(b.rotation * carried))};
    }
    case JointKind::universal: {  // b's second axis turns about the first in a; a's first axis turns the other way about the second in b
      const Vector3<T> second = b.rotation * home.b.axis[1], first = a.rotation * axis;
      return {angle_about(a.rotation, axis, home.a.axis[1], second), -angle_about(b.rotation, home.b.axis[1], home.b.axis[0], first)};
    }
    case JointKind::prismatic: {
      const Vector3<T> p_CaCb = b.origin + b.rotation * home.b.centre - a.origin - a.rotation * home.a.centre;
      return {T((a.rotation * axis).eval().dot(p_CaCb))};
    }
  }
  return {};
}

}  // namespace pmreport::mechanics
