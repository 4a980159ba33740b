#include <core/analysis/study/speed_study.hpp>

#include <core/mechanics/dynamics/virtual_work.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>
#include <core/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::analysis {

using Eigen::Index;
using Eigen::MatrixXd;
using Kind = mechanics::SpeedLimit::Kind;
using mechanics::SpeedLimit;

namespace {

// The sum of some columns of each actuator.
template <class What>
MatrixXd matrix_of(const Analysis& a, std::initializer_list<What> columns) {
  const auto& actuators = a.machine().topology().actuators;
  MatrixXd out = MatrixXd::Zero(a.samples(), static_cast<Index>(actuators.size()));
  for (std::size_t i = 0; i < actuators.size(); ++i)
    for (const What what : columns)
      out.col(static_cast<Index>(i)) += Eigen::Map<const Eigen::VectorXd>(a.column(column_of(actuators[i], what)).data(), a.samples());
  return out;
}

// All reactions in base axes, six numbers a joint, of the motion as it stands. A ball transmits no moment and has no columns of one.
MatrixXd reactions_in_motion(const Analysis& a) {
  const auto& joints = a.machine().topology().joints;
  MatrixXd out = MatrixXd::Zero(a.samples(), 6 * static_cast<Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    for (int c = 0; c < 6; ++c)
      if (const ColumnId column = reaction_column(joints[j], c, true); a.has(column))
        out.col(6 * static_cast<Index>(j) + c) = Eigen::Map<const Eigen::VectorXd>(a.column(column).data(), a.samples());
  return out;
}

// The same poses under the same loads, without rates and accelerations.
MatrixXd reactions_at_rest(const Analysis& a) {
  const mechanics::Machine& machine = a.machine();
  const scenario::Scenario& s = a.scenario();
  const auto dof = static_cast<std::size_t>(machine.dof());
  MatrixXd out = MatrixXd::Constant(a.samples(), 6 * static_cast<Index>(machine.topology().joints.size()), nan);
  mechanics::InverseDynamics dynamics(machine);
  mechanics::MotionReactions chunk;
  constexpr int most = 256;
  std::vector<int> poses;
  for (int next = 0; next < a.samples();) {
    poses.clear();
    for (; next < a.samples() && static_cast<int>(poses.size()) < most; ++next)
      if (a.outcome(next) == Outcome::good) poses.push_back(next);
    const std::size_t count = poses.size();
    if (count == 0) break;
    std::vector<double> jets(3 * dof * count, 0.0), loads(6 * count);
    for (std::size_t k = 0; k < count; ++k) {
      const auto sample = static_cast<std::size_t>(poses[k]);
      for (std::size_t i = 0; i < dof; ++i) jets[3 * i * count + k] = a.trajectory().value(poses[k], static_cast<Index>(i));
      for (std::size_t c = 0; c < 3; ++c) {
        loads[c * count + k] = s.load.force[sample](static_cast<Index>(c));
        loads[(c + 3) * count + k] = s.load.moment[sample](static_cast<Index>(c));
      }
    }
    dynamics.solve(count, jets.data(), loads.data(), s.load.gravity, chunk);
    for (Index column = 0; column < out.cols(); ++column)
      for (std::size_t k = 0; k < count; ++k) out(poses[k], column) = chunk.joints[static_cast<std::size_t>(column) * count + k];
  }
  return out;
}

}  // namespace

bool of_joint(const SpeedLimit& l) { return l.kind == Kind::joint_force || l.kind == Kind::joint_moment; }

SpeedStudy::SpeedStudy(const Analysis& a) : a_(a) {
  const mechanics::MotionLimits& limits = a.scenario().limits;
  forces_.actuator_rest = matrix_of(a, {OfActuator::load_force, OfActuator::gravity_force});
  forces_.actuator_inertia = matrix_of(a, {OfActuator::inertia_force});
  forces_.actuator_rate = matrix_of(a, {OfMotion::rate});
  for (const auto* list : {&limits.joint_force, &limits.joint_moment})
    if (std::any_of(list->begin(), list->end(), [](double x) { return std::isfinite(x); }) && forces_.joint_rest.size() == 0) {
      forces_.joint_rest = reactions_at_rest(a);
      forces_.joint_inertia = reactions_in_motion(a) - forces_.joint_rest;
    }
  feasible_ = feasible_speed(forces_, limits);
}

double SpeedStudy::duration(double scale) const { return (a_.time().back() - a_.time().front()) / scale; }

std::vector<SpeedStudy::Own> SpeedStudy::own() const {
  std::vector<Own> out;
  for (std::size_t l = 0; l < feasible_.limits.size(); ++l) {
    const SpeedLimit& one = feasible_.limits[l];
    out.push_back(
        {l, one.sample < 0 ? std::numeric_limits<double>::infinity() : one.largest[static_cast<std::size_t>(one.sample)], one.sample});
  }
  // Those that are broken even at rest by how much.
  std::stable_sort(out.begin(), out.end(), [this](const Own& x, const Own& y) {
    return x.scale != y.scale ? x.scale < y.scale : x.scale == 0 && feasible_.limits[x.limit].at_rest > feasible_.limits[y.limit].at_rest;
  });
  return out;
}

double SpeedStudy::bound(const SpeedLimit& l) const {
  const mechanics::MotionLimits& limits = a_.scenario().limits;
  const std::vector<double>* lists[] = {&limits.force, &limits.speed, &limits.power, &limits.joint_force, &limits.joint_moment};
  return (*lists[static_cast<int>(l.kind)])[static_cast<std::size_t>(l.index)];
}

std::vector<double> SpeedStudy::demand(const SpeedLimit& l, double s) const {
  std::vector<double> out;
  for (Index k = 0; k < a_.samples(); ++k) {
    if (of_joint(l)) {
      const Index first = 6 * l.index + (l.kind == Kind::joint_force ? 0 : 3);
      out.push_back((forces_.joint_rest.row(k).segment<3>(first) + s * s * forces_.joint_inertia.row(k).segment<3>(first)).norm());
      continue;
    }
    const double rate = s * forces_.actuator_rate(k, l.index);
    const double force = forces_.actuator_rest(k, l.index) + s * s * forces_.actuator_inertia(k, l.index);
    out.push_back(l.kind == Kind::actuator_force ? force : l.kind == Kind::actuator_speed ? rate : force * rate);
  }
  return out;
}

double SpeedStudy::asked_anew(const SpeedLimit& l, int sample, double s) const {
  const mechanics::Machine& machine = a_.machine();
  const scenario::Scenario& scenario = a_.scenario();
  const Eigen::VectorXd q = a_.trajectory().value.row(sample), rate = s * a_.trajectory().rate.row(sample),
                        acceleration = s * s * a_.trajectory().acceleration.row(sample);
  mechanics::State state;
  evaluate(machine, q.data(), rate.data(), acceleration.data(), state);
  mechanics::Loading loading;
  loading.platform << scenario.load.force[static_cast<std::size_t>(sample)], scenario.load.moment[static_cast<std::size_t>(sample)];
  loading.gravity = scenario.load.gravity;
  const auto i = static_cast<std::size_t>(l.index);
  if (l.kind == Kind::actuator_speed) return std::abs(state.actuators[i].rate) / bound(l);
  const auto r = dense_reactions(machine, state, generic_model(machine, state), mechanics::JointFrames(machine), loading, a_.length());
  if (l.kind == Kind::joint_force) return r.joints[i].head<3>().norm() / bound(l);
  if (l.kind == Kind::joint_moment) return r.joints[i].tail<3>().norm() / bound(l);
  const double force = std::abs(r.actuator_forces(l.index));
  return (l.kind == Kind::actuator_force ? force : force * std::abs(state.actuators[i].rate)) / bound(l);
}

std::optional<SpeedStudy::Proof> SpeedStudy::proof() const {
  if (feasible_.limit < 0 || !(scale() > 0)) return std::nullopt;
  const auto asked = [&](std::size_t l, int sample) { return asked_anew(feasible_.limits[l], sample, scale()); };
  double most = 0;
  for (const Own& o : own())
    if (o.sample >= 0) most = std::max(most, asked(o.limit, o.sample) - 1);
  return Proof{std::abs(asked(static_cast<std::size_t>(feasible_.limit), feasible_.sample) - 1), most};
}

}  // namespace pmreport::analysis
