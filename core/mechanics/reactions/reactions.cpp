#include <core/mechanics/reactions/reactions.hpp>

#include <core/assertion.hpp>
#include <core/linear/least_norm.hpp>
#include <core/linear/subspace.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

double size_of(const Vector6d& wrench, double length) {
  return std::max(wrench.head<3>().lpNorm<Eigen::Infinity>(), wrench.tail<3>().lpNorm<Eigen::Infinity>() / length);
}

// The wrenches on body b of each joint, about its centre, from the multipliers of the rows of PHI.
std::vector<Vector6d> joint_wrenches(const Machine& machine, const State& state, const GenericModel& model, const VectorXd& lambda) {
  const Topology& t = machine.topology();
  std::vector<Vector6d> out(t.joints.size(), Vector6d::Zero());
  for (std::size_t r = 0; r < model.joint_of_row.size(); ++r) {
    const auto j = static_cast<std::size_t>(model.joint_of_row[r]);
    const int body = t.joints[j].b > 0 ? t.joints[j].b : t.joints[j].a;
    Vector6d row = model.constraints.block<1, 6>(static_cast<Index>(r), 6 * body - 6).transpose();
    if (body != t.joints[j].b) row = -row;
    row.tail<3>() -= (state.joints[j].centre - state.bodies[static_cast<std::size_t>(body)].origin).cross(row.head<3>());
    out[j] += row * lambda(static_cast<Index>(r));
  }
  return out;
}

// Calls f(body, wrench about that body's origin) for both bodies of a joint, of the wrench on its body b about its centre.
template <class F>
void each_side(const State& state, const Joint& joint, const Vector3d& centre, const Vector6d& wrench, F&& f) {
  for (const auto& [body, sign] : {std::pair{joint.b, 1.0}, std::pair{joint.a, -1.0}}) {
    if (body == 0) continue;
    Vector6d w = sign * wrench;
    w.tail<3>() += (centre - state.bodies[static_cast<std::size_t>(body)].origin).cross(w.head<3>());
    f(body, w);
  }
}

// What an actuator exerts on body b of its joint, about the joint's centre.
Vector6d drive_wrench(const Actuator& actuator, const State& state, double force) {
  Vector6d w = Vector6d::Zero();
  (actuator.sense() == Sense::linear ? w.head<3>() : w.tail<3>()) = force * state.joints[static_cast<std::size_t>(actuator.joint)].axis[0];
  return w;
}

}  // namespace

Vector6d in_axes(const Matrix3d& frame, const Vector6d& wrench) {
  return (Vector6d() << frame.transpose() * wrench.head<3>(), frame.transpose() * wrench.tail<3>()).finished();
}

std::vector<Indeterminate> indeterminate_components(const State& state, const JointFrames& frames,
                                                    const std::vector<std::vector<Vector6d>>& stresses, double length) {
  std::vector<Indeterminate> out(state.joints.size(), 0);
  for (const std::vector<Vector6d>& stress : stresses) {
    double largest = 0;
    for (const Vector6d& w : stress) largest = std::max(largest, size_of(w, length));
    for (std::size_t j = 0; j < stress.size(); ++j) {
      const Vector6d local = in_axes(frames(state, static_cast<int>(j)), stress[j]);
      for (int c = 0; c < 6; ++c) {
        const double least = linear::carried_share * largest * (c < 3 ? 1 : length);
        if (std::abs(local(c)) > least) out[j] = static_cast<Indeterminate>(out[j] | 1 << c);
        if (std::abs(stress[j](c)) > least) out[j] = static_cast<Indeterminate>(out[j] | 64 << c);
      }
    }
  }
  return out;
}

double free_body_residual(const Machine& machine, const State& state, const std::vector<Vector6d>& joints, const VectorXd& actuator_forces,
                          const VectorXd& required, double length) {
  const Topology& t = machine.topology();
  VectorXd unbalanced = -required;
  double largest = 0;
  for (Index at = 0; at < required.size(); at += 6) largest = std::max(largest, size_of(required.segment<6>(at), length));
  const auto act = [&](int joint, const Vector6d& wrench) {
    const auto j = static_cast<std::size_t>(joint);
    largest = std::max(largest, size_of(wrench, length));
    each_side(state, t.joints[j], state.joints[j].centre, wrench,
              [&](int body, const Vector6d& w) { unbalanced.segment<6>(6 * body - 6) += w; });
  };
  for (std::size_t j = 0; j < joints.size(); ++j) act(static_cast<int>(j), joints[j]);
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    act(t.actuators[i].joint, drive_wrench(t.actuators[i], state, actuator_forces(static_cast<Index>(i))));
  double worst = 0;
  for (Index at = 0; at < unbalanced.size(); at += 6) worst = std::max(worst, size_of(unbalanced.segment<6>(at), length));
  return largest > 0 ? worst / largest : worst;
}

std::vector<Vector6d> limb_wrenches(const Machine& machine, const State& state, const JointReactions& reactions) {
  const Topology& t = machine.topology();
  int limbs = 0;
  for (const Body& b : t.bodies) limbs = std::max(limbs, b.limb);
  std::vector<Vector6d> out(static_cast<std::size_t>(limbs), Vector6d::Zero());
  const auto act = [&](int joint, const Vector6d& wrench) {
    const Joint& at = t.joints[static_cast<std::size_t>(joint)];
    if (at.a != t.platform && at.b != t.platform) return;
    const int limb = t.bodies[static_cast<std::size_t>(at.a == t.platform ? at.b : at.a)].limb;
    if (limb == 0) return;
    each_side(state, at, state.joints[static_cast<std::size_t>(joint)].centre, wrench, [&](int body, const Vector6d& w) {
      if (body == t.platform) out[static_cast<std::size_t>(limb - 1)] += w;
    });
  };
  for (std::size_t j = 0; j < reactions.joints.size(); ++j) act(static_cast<int>(j), reactions.joints[j]);
  for (std::size_t i = 0; i < t.actuators.size(); ++i)
    act(t.actuators[i].joint, drive_wrench(t.actuators[i], state, reactions.actuator_forces(static_cast<Index>(i))));
  return out;
}

namespace {

// (1) for lambda and tau together. Moments count per length, and so do multipliers of couples: the norm of a solution is that of the
// header. A couple has no force.
MatrixXd equations(const GenericModel& model, double length) {
  MatrixXd all(model.constraints.rows() + model.actuation.rows(), model.constraints.cols());
  all << model.constraints, model.actuation;
  return per_length(std::move(all), length).transpose();
}
VectorXd scale_of(const MatrixXd& system) {
  VectorXd scale = VectorXd::Ones(system.cols());
  for (Index c = 0; c < system.cols(); ++c) {
    double force = 0, couple = 0;
    for (Index at = 0; at < system.rows(); at += 6) {
      force = std::max(force, system.col(c).segment<3>(at).norm());
      couple = std::max(couple, system.col(c).segment<3>(at + 3).norm());
    }
    if (force == 0) scale(c) = 1 / couple;
  }
  return scale;
}

}  // namespace

DenseSystem::DenseSystem(const Machine& machine, const State& state, const GenericModel& model, const JointFrames& frames, double length)
    : machine_(machine),
      state_(state),
      model_(model),
      length_(length),
      scale_(scale_of(equations(model, length))),
      solver_(equations(model, length) * scale_.asDiagonal(), linear::rank_tolerance) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  const Index rows = model.constraints.rows(), m = model.actuation.rows();
  const MatrixXd null = scale_.asDiagonal() * linear::null_space(equations(model, length) * scale_.asDiagonal());
  for (Index k = 0; k < null.cols(); ++k) {
    stresses_.stresses.push_back(joint_wrenches(machine, state, model, null.col(k).head(rows)));
    if (null.col(k).tail(m).cwiseAbs().maxCoeff() > linear::carried_share * null.col(k).cwiseAbs().maxCoeff()) stresses_.singular = true;
  }
  stresses_.indeterminate = indeterminate_components(state, frames, stresses_.stresses, length);
}

JointReactions DenseSystem::reactions(const VectorXd& required) const {
  VectorXd right = required;
  for (Index at = 0; at < right.size(); at += 6) right.segment<3>(at + 3) /= length_;
  const VectorXd x = scale_.asDiagonal() * solver_.solve(right);
  const Index m = model_.actuation.rows();
  JointReactions out = stresses_;
  out.actuator_forces = x.tail(m);
  out.joints = joint_wrenches(machine_, state_, model_, x.head(x.size() - m));
  out.residual = free_body_residual(machine_, state_, out.joints, out.actuator_forces, required, length_);
  return out;
}

JointReactions dense_reactions(const Machine& machine, const State& state, const GenericModel& model, const JointFrames& frames,
                               const Loading& loading, double length) {
  return DenseSystem(machine, state, model, frames, length)
      .reactions(inertial_wrenches(machine, state) - applied_wrenches(machine, state, loading));
}

}  // namespace pmreport::mechanics
