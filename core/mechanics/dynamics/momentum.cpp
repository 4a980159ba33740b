#include <core/mechanics/dynamics/momentum.hpp>

#include <core/assertion.hpp>
#include <core/mechanics/statics/statics.hpp>

#include <Eigen/Geometry>

namespace pmreport::mechanics {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

Matrix3d cross_matrix(const Vector3d& v) { return (Matrix3d() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0).finished(); }

Matrix3d in_base_axes(const Inertia& inertia, const BodyState& b) { return b.rotation * inertia.about_centre * b.rotation.transpose(); }

// Calls f(number, inertia, state) for the bodies 1..n.
template <class F>
void each_body(const Machine& machine, const State& state, F&& f) {
  for (std::size_t i = 1; i < state.bodies.size(); ++i) f(static_cast<int>(i), machine.topology().bodies[i].inertia, state.bodies[i]);
}

}  // namespace

VectorXd inertial_wrenches(const Machine& machine, const State& state) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  VectorXd w(6 * (static_cast<int>(state.bodies.size()) - 1));
  each_body(machine, state, [&](int i, const Inertia& inertia, const BodyState& b) {
    const Vector3d p_AC = b.rotation * inertia.centre, &w_A = b.angular_velocity;
    const Vector3d force = inertia.mass * (b.acceleration + b.angular_acceleration.cross(p_AC) + w_A.cross(w_A.cross(p_AC)));  // (1)
    const Vector3d w_A_A = b.rotation.transpose() * w_A, e_A_A = b.rotation.transpose() * b.angular_acceleration;
    const Vector3d couple = b.rotation * (inertia.about_centre * e_A_A + w_A_A.cross(inertia.about_centre * w_A_A));
    w.segment<3>(6 * i - 6) = force;
    w.segment<3>(6 * i - 3) = p_AC.cross(force) + couple;  // (2)
  });
  return w;
}

VectorXd applied_wrenches(const Machine& machine, const State& state, const Loading& loading) {
  VectorXd w = weights(machine, state, loading.gravity);
  w.segment<6>(6 * machine.topology().platform - 6) += loading.platform;
  return w;
}

double kinetic_energy(const Machine& machine, const State& state) {
  double energy = 0;
  each_body(machine, state, [&](int, const Inertia& inertia, const BodyState& b) {
    const Vector3d v_C = b.velocity + b.angular_velocity.cross(b.rotation * inertia.centre);
    energy += 0.5 * inertia.mass * v_C.squaredNorm() + 0.5 * b.angular_velocity.dot(in_base_axes(inertia, b) * b.angular_velocity);
  });
  return energy;
}

double potential_energy(const Machine& machine, const State& state, const Vector3d& gravity) {
  double energy = 0;
  each_body(machine, state, [&](int, const Inertia& inertia, const BodyState& b) {
    energy -= inertia.mass * gravity.dot(b.origin + b.rotation * inertia.centre);
  });
  return energy;
}

// (3).
Matrix6d mass_matrix(const Inertia& inertia, const BodyState& b) {
  const Matrix3d c = cross_matrix(b.rotation * inertia.centre);
  Matrix6d m;
  m << inertia.mass * Matrix3d::Identity(), -inertia.mass * c, inertia.mass * c, in_base_axes(inertia, b) - inertia.mass * c * c;
  return m;
}

}  // namespace pmreport::mechanics
