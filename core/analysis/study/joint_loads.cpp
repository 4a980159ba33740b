#include <core/analysis/study/joint_loads.hpp>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pmreport::analysis {

using Eigen::Vector3d;
using mechanics::Vector6d;

namespace {

constexpr double nothing = 1e-9;  // of the largest: rounding of what vanishes

const std::vector<double>* size_column(const Analysis& a, const Joint& joint, bool moment) {
  if (moment && joint.kind == JointKind::spherical) return nullptr;
  return &a.column(column_of(joint, moment ? OfJoint::moment : OfJoint::force));
}

JointLoad::Size size_of(const Analysis& a, const Joint& joint, bool moment) {
  JointLoad::Size out;
  const std::vector<double>* x = size_column(a, joint, moment);
  if (x == nullptr) return out;
  double squares = 0;
  int count = 0;
  for (int k = 0; k < a.samples(); ++k) {
    const double value = (*x)[static_cast<std::size_t>(k)];
    if (!std::isfinite(value)) continue;
    squares += value * value, ++count;
    if (out.sample < 0 || value > out.peak) out.peak = value, out.sample = k;
  }
  if (count > 0) out.rms = std::sqrt(squares / count);
  return out;
}

double angle_between(const Vector3d& u, const Vector3d& v) { return 2 * std::asin(std::min(1.0, (u - v).norm() / 2)); }

// The mean of the directions, each force that counts once, and the force farthest from it. Of forces that reverse, the line with the least
// sum of squared sines of angles to it: the eigenvector of sum u u^T with the largest eigenvalue.
void find_cone(const Analysis& a, const Joint& joint, JointLoad& load) {
  std::vector<Vector3d> directions;
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (int k = 0; k < a.samples(); ++k) {
    const Vector3d f(component(a, joint, 0, k), component(a, joint, 1, k), component(a, joint, 2, k));
    if (!(f.norm() > directionless * load.force.peak)) continue;
    const Vector3d u = f.normalized();
    directions.push_back(u);
    sum += u;
    spread += u * u.transpose();
  }
  const auto cone_about = [&](const Vector3d& axis, bool either_way) {
    double widest = 0;
    for (const Vector3d& u : directions) widest = std::max(widest, angle_between(either_way && u.dot(axis) < 0 ? Vector3d(-u) : u, axis));
    return widest;
  };
  load.direction = sum.normalized();
  load.cone = cone_about(load.direction, false);
  load.reverses = load.cone > std::numbers::pi / 2 || load.direction.isZero();
  if (!load.reverses) return;
  load.direction = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  if (load.direction.dot(sum) < 0) load.direction = -load.direction;
  load.cone = cone_about(load.direction, true);
}

}  // namespace

double component(const Analysis& a, const Joint& joint, int c, int sample) {
  return transmits(joint.kind, c) ? a.column(reaction_column(joint, c, false))[static_cast<std::size_t>(sample)] : 0;
}

std::vector<JointLoad> joint_loads(const Analysis& a) {
  const Topology& t = a.machine().topology();
  std::vector<JointLoad> out(t.joints.size());
  double force = 0, moment = 0;
  for (std::size_t j = 0; j < out.size(); ++j) {
    out[j].force = size_of(a, t.joints[j], false);
    out[j].moment = size_of(a, t.joints[j], true);
    force = std::max(force, out[j].force.peak), moment = std::max(moment, out[j].moment.peak);
  }
  moment = std::max(moment, force * a.length());  // a mechanism of forces alone has moments of rounding
  for (std::size_t j = 0; j < out.size(); ++j) {
    JointLoad& load = out[j];
    if (load.force.peak <= nothing * force) load.force = {};
    if (load.moment.peak <= nothing * moment) load.moment = {};
    for (int c = 0; c < 6; ++c)
      if (transmits(t.joints[j].kind, c)) {
        load.doubtful = static_cast<Indeterminate>(load.doubtful | (a.indeterminate()[j] & 1 << c));
        load.elastic = static_cast<Indeterminate>(load.elastic | (a.elastic_reactions().settled[j] & ~a.indeterminate()[j] & 1 << c));
      }
    if (load.force.sample >= 0) find_cone(a, t.joints[j], load);
  }
  return out;
}

mechanics::State state_of(const Analysis& a, int sample) {
  const mechanics::Trajectory& motion = a.trajectory();
  const Eigen::VectorXd q = motion.value.row(sample), rate = motion.rate.row(sample), acceleration = motion.acceleration.row(sample);
  mechanics::State state;
  evaluate(a.machine(), q.data(), rate.data(), acceleration.data(), state);
  return state;
}

std::vector<int> samples_with_forces(const Analysis& a, int count) {
  std::vector<int> good, out;
  const std::vector<double>& size = a.column(column_of(a.machine().topology().joints.front(), OfJoint::force));
  for (int k = 0; k < a.samples(); ++k)
    if (std::isfinite(size[static_cast<std::size_t>(k)])) good.push_back(k);
  const std::size_t n = std::min(good.size(), static_cast<std::size_t>(std::max(count, 1)));
  for (std::size_t i = 0; i < n; ++i) out.push_back(good[n > 1 ? i * (good.size() - 1) / (n - 1) : 0]);
  return out;
}

std::vector<Vector6d> at_joints(const mechanics::State& state, const mechanics::SelfStress& stress) {
  std::vector<Vector6d> out(state.joints.size(), Vector6d::Zero());
  for (const auto& share : stress.shares) {
    const auto j = static_cast<std::size_t>(share.joint);
    out[j] = share.wrench;
    out[j].tail<3>() -= state.joints[j].centre.cross(share.wrench.head<3>());
  }
  return out;
}

}  // namespace pmreport::analysis
