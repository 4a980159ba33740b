#include <core/analysis/samples/sample_stiffness.hpp>

#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/stiffness/whole_system.hpp>

#include <algorithm>
#include <cmath>

namespace pmreport::analysis {

using mechanics::ElasticPose, mechanics::Matrix6d, mechanics::Spring, mechanics::Vector6d;

namespace {

// Largest deviation of two compliances, rotations scaled by a length, relative to the largest number.
double deviation(const Matrix6d& a, const Matrix6d& b, double length) {
  const Vector6d s = (Vector6d() << 1, 1, 1, Eigen::Vector3d::Constant(1 / length)).finished();
  const Matrix6d d = s.asDiagonal() * (a - b) * s.asDiagonal(), all = s.asDiagonal() * b * s.asDiagonal();
  return relative(d.cwiseAbs().maxCoeff(), all.cwiseAbs().maxCoeff());
}

}  // namespace

void SampleStiffness::run(int sample, bool judged, Row& row, const Put& put, Matrix6d& compliance) {
  const auto k = static_cast<std::size_t>(sample);
  const auto dof = static_cast<std::size_t>(machine_.dof());
  std::vector<double> jets(3 * dof), loads(6);
  std::vector<double> q(dof);
  for (std::size_t i = 0; i < dof; ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    q[i] = jets[3 * i] = trajectory_.value(sample, at);
    jets[3 * i + 1] = trajectory_.rate(sample, at);
    jets[3 * i + 2] = trajectory_.acceleration(sample, at);
  }
  if (machine_.place(PM_VALUE, 1, q.data(), placement_.data()) != PM_OK) return;
  for (std::size_t c = 0; c < 3; ++c) {
    loads[c] = load_.force[k](static_cast<Eigen::Index>(c));
    loads[3 + c] = load_.moment[k](static_cast<Eigen::Index>(c));
  }
  statics_.solve(1, jets.data(), loads.data(), load_.gravity, {true, request_.limb_inertia}, poses_);
  const ElasticPose& pose = poses_[0];
  if (!pose.known) return;
  const ToolElasticity tool = at_tool(machine_, pose, placement_.data(), request_);
  compliance = tool.compliance;
  stiffness_numbers(machine_, pose, tool, request_, length_, true, put);
  if (judged) prove(sample, Eigen::Map<const Vector6d>(loads.data()), pose, row);
}

void SampleStiffness::prove(int sample, const Vector6d& load, const ElasticPose& pose, Row& row) {
  prove_drives(pose, row);
  if (!machine_.elasticity().platform.isZero(0) || !machine_.elasticity().base.isZero(0) || pose.compliance.isZero(0)) return;
  mechanics::State state;
  const Eigen::VectorXd q = trajectory_.value.row(sample), rate = trajectory_.rate.row(sample),
                        acceleration = trajectory_.acceleration.row(sample);
  evaluate(machine_, q.data(), rate.data(), acceleration.data(), state);
  if (state.status != PM_OK) return;
  const mechanics::WholeSystem whole(statics_.plan(), state);
  const Eigen::Index platform = 6 * machine_.topology().platform - 6;
  set(row, Measure::elastic_judge, deviation(pose.compliance, whole.under_unit_wrenches().middleRows<6>(platform), length_));
  // What acts on the bodies, less what their motion takes, along the displacements of all of them; and the energy of the springs.
  const Eigen::VectorXd wrenches = applied_wrenches(machine_, state, {load, load_.gravity}) - inertial_wrenches(machine_, state);
  const double work = wrenches.dot(Eigen::VectorXd(whole.displacements(wrenches)));
  double energy = 0;
  for (std::size_t i = 0; i < pose.parts.springs.size(); ++i)
    energy += pose.parts.springs[i].compliance * std::pow(pose.loaded(static_cast<Eigen::Index>(i)), 2);
  set(row, Measure::elastic_work, relative(std::abs(work - energy), std::max(work, energy)));
}

// The part of the drives in the compliance, by their forces and by G: G^-1 diag(1/k) G^-T.
void SampleStiffness::prove_drives(const ElasticPose& pose, Row& row) const {
  const mechanics::Jacobian g = machine_.jacobian(placement_.data());
  if (!g.known()) return;
  Matrix6d seen = Matrix6d::Zero(), compliances = Matrix6d::Zero();
  for (std::size_t i = 0; i < pose.parts.springs.size(); ++i) {
    const Spring& s = pose.parts.springs[i];
    if (s.kind != Spring::Kind::drive) continue;
    const Vector6d q = pose.unit.row(static_cast<Eigen::Index>(i)).transpose();
    seen += s.compliance * q * q.transpose();
    compliances(s.actuator, s.actuator) += s.compliance;
  }
  if (compliances.isZero(0)) return;
  const Matrix6d inverse = g.matrix.inverse();
  set(row, Measure::elastic_drives, deviation(seen, inverse * compliances * inverse.transpose(), length_));
}

}  // namespace pmreport::analysis
