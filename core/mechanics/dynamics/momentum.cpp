#include <core/mechanics/dynamics/momentum.hpp>

#include <core/mechanics/model/generic_model.hpp>

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
  VectorXd w(6 * (static_cast<int>(state.bodies.size()) - 1));
  each_body(machine, state, [&](int i, const Inertia& inertia, const BodyState& b) {
    const Vector3d c = b.rotation * inertia.centre, &rate = b.angular_velocity;
    const Vector3d force = inertia.mass * (b.acceleration + b.angular_acceleration.cross(c) + rate.cross(rate.cross(c)));
    const Vector3d turn = b.rotation.transpose() * rate, turn_rate = b.rotation.transpose() * b.angular_acceleration;  // in body axes
    const Vector3d couple = b.rotation * (inertia.about_centre * turn_rate + turn.cross(inertia.about_centre * turn));
    w.segment<3>(6 * i - 6) = force;
    w.segment<3>(6 * i - 3) = c.cross(force) + couple;
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
    const Vector3d velocity = b.velocity + b.angular_velocity.cross(b.rotation * inertia.centre);
    energy += 0.5 * inertia.mass * velocity.squaredNorm() + 0.5 * b.angular_velocity.dot(in_base_axes(inertia, b) * b.angular_velocity);
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

Matrix6d mass_matrix(const Inertia& inertia, const BodyState& b) {
  const Matrix3d c = cross_matrix(b.rotation * inertia.centre);
  Matrix6d m;
  m << inertia.mass * Matrix3d::Identity(), -inertia.mass * c, inertia.mass * c, in_base_axes(inertia, b) - inertia.mass * c * c;
  return m;
}

}  // namespace pmreport::mechanics
