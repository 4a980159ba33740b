#include <core/analysis/samples/sample_forces.hpp>

#include <core/mechanics/dynamics/drive.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using Eigen::Index;
using Eigen::VectorXd;
using mechanics::Indeterminate;
using mechanics::SmallVector;
using mechanics::Vector6d;

namespace {

void put(double* column, std::size_t k, double value) {
  if (column != nullptr && std::isfinite(value)) column[k] = value + 0.0;  // no negative zero
}

}  // namespace

SampleForces::SampleForces(const mechanics::Trajectory& trajectory, const scenario::Load& load,
                           const std::vector<mechanics::DriveTrain>& drives, const mechanics::Machine& m,
                           const mechanics::JointFrames& frames, double length, bool evidence)
    : trajectory_(trajectory),
      load_(load),
      drives_(drives),
      machine_(m),
      frames_(frames),
      length_(length),
      evidence_(evidence),
      dynamics_(m),
      split_(m) {
  loading_.gravity = load.gravity;
  reactions_.joints.resize(m.topology().joints.size());
  reactions_.actuator_forces.resize(m.dof());
}

ReactionFindings SampleForces::run(std::span<const Order> orders, const Into& into) {
  found_ = ReactionFindings(machine_.topology().joints.size());
  solve(orders);
  const mechanics::Trajectory& motion = trajectory_;
  for (std::size_t k = 0; k < orders.size(); ++k) {
    const Order& order = orders[k];
    const auto sample = static_cast<std::size_t>(order.sample), row = static_cast<std::size_t>(order.sample - into.first);
    if (!take(k, orders.size())) continue;
    const SmallVector q = motion.value.row(order.sample), rate = motion.rate.row(order.sample),
                      acceleration = motion.acceleration.row(order.sample);
    evaluate(machine_, q.data(), rate.data(), acceleration.data(), state_);
    loading_.platform << load_.force[sample], load_.moment[sample];
    settle(k, orders.size(), order.sample);
    const mechanics::Tangent t = tangent(machine_, state_);
    const mechanics::ForceShares shares = virtual_work(machine_, state_, t, loading_);
    const SmallVector total = shares.total();
    put_actuators(into.columns, row, shares, total);
    put_drives(into.columns, row, t, total);
    put_reactions(into.columns, row);

    if (evidence_) prove(order, shares, total, into.rows[row]);
  }
  return std::move(found_);
}

// Of what `take` took.
void SampleForces::prove(const Order& order, const mechanics::ForceShares& shares, const SmallVector& total, Row& row) const {
  const VectorXd required = inertial_wrenches(machine_, state_) - applied_wrenches(machine_, state_, loading_);
  set(row, Measure::free_body, free_body_residual(machine_, state_, reactions_.joints, reactions_.actuator_forces, required, length_));
  if (!order.compared) return;
  // Shares that cancel leave their rounding behind.
  double scale = required.lpNorm<Eigen::Infinity>();
  for (const SmallVector* share : {&shares.load, &shares.gravity, &shares.inertia})
    scale = std::max(scale, share->lpNorm<Eigen::Infinity>());
  set(row, Measure::newton_euler, relative((total - reactions_.actuator_forces).lpNorm<Eigen::Infinity>(), scale));
  // Where the one system over all bodies is the only way there is, it is no judge of itself.
  if (order.judged && dynamics_.limb_by_limb()) set(row, Measure::judge, judge());
}

void SampleForces::solve(std::span<const Order> orders) {
  const std::size_t count = orders.size(), dof = static_cast<std::size_t>(machine_.dof());
  const mechanics::Trajectory& motion = trajectory_;
  jets_.resize(3 * dof * count);
  loads_.resize(6 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const Index sample = orders[k].sample;
    for (std::size_t i = 0; i < dof; ++i) {
      const auto column = static_cast<Index>(i);
      jets_[3 * i * count + k] = motion.value(sample, column);
      jets_[(3 * i + 1) * count + k] = motion.rate(sample, column);
      jets_[(3 * i + 2) * count + k] = motion.acceleration(sample, column);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      loads_[c * count + k] = load_.force[static_cast<std::size_t>(sample)](static_cast<Index>(c));
      loads_[(3 + c) * count + k] = load_.moment[static_cast<std::size_t>(sample)](static_cast<Index>(c));
    }
  }
  dynamics_.solve(count, jets_.data(), loads_.data(), load_.gravity, chunk_);
  found_.self_stresses = chunk_.stress_count;
}

bool SampleForces::take(std::size_t k, std::size_t count) {
  for (Index i = 0; i < reactions_.actuator_forces.size(); ++i)
    reactions_.actuator_forces(i) = chunk_.actuator_forces[static_cast<std::size_t>(i) * count + k];
  if (!reactions_.actuator_forces.allFinite()) return false;
  for (std::size_t j = 0; j < reactions_.joints.size(); ++j)
    for (std::size_t c = 0; c < 6; ++c) reactions_.joints[j](static_cast<Index>(c)) = chunk_.joints[(6 * j + c) * count + k];
  return true;
}

void SampleForces::settle(std::size_t k, std::size_t count, int sample) {
  least_norm_ = reactions_.joints;
  const auto rigid = [&](std::size_t j) { return chunk_.indeterminate[j * count + k]; };
  std::vector<Indeterminate>& indeterminate = found_.indeterminate;
  if (!split_.any() || chunk_.stress_count == 0) {
    for (std::size_t j = 0; j < indeterminate.size(); ++j) indeterminate[j] = static_cast<Indeterminate>(indeterminate[j] | rigid(j));
    return;
  }
  ElasticReactions& elastic = found_.elastic;
  const auto answer = split_.add(state_.placement_jets.data(), 3, chunk_, k, count, reactions_.joints);
  elastic.stresses = std::max(elastic.stresses, answer.settled);
  elastic.open = std::max(elastic.open, static_cast<int>(answer.open.size()));
  const auto open = indeterminate_components(state_, frames_, answer.open, length_);
  for (std::size_t j = 0; j < indeterminate.size(); ++j) {
    indeterminate[j] = static_cast<Indeterminate>(indeterminate[j] | (rigid(j) & open[j]));
    elastic.settled[j] = static_cast<Indeterminate>(elastic.settled[j] | (rigid(j) & ~open[j]));
    const Vector6d missed = reactions_.joints[j] - least_norm_[j];
    const int joint = static_cast<int>(j);
    if (const double f = missed.head<3>().norm(); f > elastic.force)
      elastic.force = f, elastic.force_joint = joint, elastic.force_sample = sample;
    if (const double m = missed.tail<3>().norm(); m > elastic.moment)
      elastic.moment = m, elastic.moment_joint = joint, elastic.moment_sample = sample;
  }
}

void SampleForces::put_actuators(const ForceColumns& to, std::size_t k, const mechanics::ForceShares& shares, const SmallVector& total) {
  double power = 0;
  for (std::size_t i = 0; i < to.actuators.size(); ++i) {
    const auto at = static_cast<Index>(i);
    const ForceColumns::ActuatorColumns& column = to.actuators[i];
    const double own = total(at) * state_.actuators[i].rate;
    put(column.force, k, total(at));
    put(column.load, k, shares.load(at));
    put(column.gravity, k, shares.gravity(at));
    put(column.inertia, k, shares.inertia(at));
    put(column.power, k, own);
    power += own;
  }
  put(to.total_power, k, power);
  put(to.load_power, k, loading_.platform.dot(state_.bodies[static_cast<std::size_t>(machine_.topology().platform)].twist()));
  put(to.kinetic_energy, k, kinetic_energy(machine_, state_));
  put(to.potential_energy, k, potential_energy(machine_, state_, loading_.gravity));
}

void SampleForces::put_drives(const ForceColumns& to, std::size_t k, const mechanics::Tangent& tangent, const SmallVector& total) {
  if (to.actuators.front().drive_force == nullptr) return;
  const SmallVector inertia = reflected_inertia(tangent, equations_of_motion(machine_, state_, tangent, loading_.gravity).mass);
  for (std::size_t i = 0; i < to.actuators.size(); ++i) {
    const auto at = static_cast<Index>(i);
    const ForceColumns::ActuatorColumns& column = to.actuators[i];
    const mechanics::Scalar& x = state_.actuators[i];
    const mechanics::DriveTrain& drive = drives_.at(i);
    const double force = drive_force(drive, total(at), x.rate);
    put(column.drive_force, k, force);
    put(column.drive_power, k, force * x.rate);
    put(column.reflected_inertia, k, inertia(at));
    if (column.motor_torque == nullptr) continue;
    const mechanics::MotorState motor = mechanics::motor(drive, total(at), x.rate, x.acceleration);
    put(column.motor_torque, k, motor.torque);
    put(column.motor_speed, k, motor.speed);
    put(column.motor_power, k, motor.power());
  }
}

void SampleForces::put_reactions(const ForceColumns& to, std::size_t k) {
  for (std::size_t j = 0; j < to.joints.size(); ++j) {
    const ForceColumns::JointColumns& column = to.joints[j];
    if (column.force == nullptr) return;
    const Vector6d& wrench = reactions_.joints[j];
    const Vector6d local = mechanics::in_axes(frames_(state_, static_cast<int>(j)), wrench);
    put(column.force, k, wrench.head<3>().norm());
    put(column.moment, k, wrench.tail<3>().norm());
    for (std::size_t c = 0; c < 6; ++c) {
      put(column.joint_axes[c], k, local(static_cast<Index>(c)));
      put(column.base_axes[c], k, wrench(static_cast<Index>(c)));
    }
  }
  const std::vector<Vector6d> limbs = limb_wrenches(machine_, state_, reactions_);
  for (std::size_t i = 0; i < limbs.size(); ++i)
    for (std::size_t c = 0; c < 6; ++c) put(to.limbs[i][c], k, limbs[i](static_cast<Index>(c)));
}

// Largest deviation of a force, or a moment per length, of what `take` took; relative to the largest in any joint.
double SampleForces::judge() const {
  const mechanics::JointReactions other = dense_reactions(machine_, state_, generic_model(machine_, state_), frames_, loading_, length_);
  double deviation = (other.actuator_forces - reactions_.actuator_forces).lpNorm<Eigen::Infinity>();
  double scale = other.actuator_forces.lpNorm<Eigen::Infinity>();
  for (std::size_t j = 0; j < other.joints.size(); ++j) {
    const Vector6d difference = other.joints[j] - least_norm_[j];
    deviation = std::max({deviation, difference.head<3>().norm(), difference.tail<3>().norm() / length_});
    scale = std::max({scale, other.joints[j].head<3>().norm(), other.joints[j].tail<3>().norm() / length_});
  }
  return relative(deviation, scale);
}

}  // namespace pmreport::analysis
