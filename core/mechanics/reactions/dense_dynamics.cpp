#include <core/mechanics/reactions/dense_dynamics.hpp>

#include <core/linear/subspace.hpp>
#include <core/mechanics/model/constraint_scale.hpp>
#include <core/numbers.hpp>

#include <Eigen/Geometry>
#include <algorithm>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

// The pivot that decides whether the actuators hold every body, idle spins aside, over the largest.
double regularity_of(const GenericModel& model, int idle, double length) {
  MatrixXd system(model.constraints.rows() + model.actuation.rows(), model.constraints.cols());
  system << model.constraints, model.actuation;
  system = unit_rows(std::move(system), length);
  const Index last = system.cols() - idle - 1;
  if (last >= system.rows()) return 0;
  const VectorXd pivots = linear::pivots(system);
  return pivots(last) / pivots(0);
}

// The wrenches of all joints as one vector whose square is the norm of reactions.hpp.
VectorXd scaled(const std::vector<Vector6d>& joints, double length) {
  VectorXd out(6 * static_cast<Index>(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j)
    out.segment<6>(6 * static_cast<Index>(j)) << joints[j].head<3>(), joints[j].tail<3>() / length;
  return out;
}

MatrixXd orthonormal(const std::vector<std::vector<Vector6d>>& stresses, double length) {
  MatrixXd all(6 * static_cast<Index>(stresses[0].size()), static_cast<Index>(stresses.size()));
  for (Index s = 0; s < all.cols(); ++s) all.col(s) = scaled(stresses[static_cast<std::size_t>(s)], length);
  return linear::orthonormalised(all);
}

}  // namespace

DenseDynamics::DenseDynamics(const Machine& machine) : machine_(machine), frames_(machine), length_(characteristic_length(machine)) {}

JointReactions DenseDynamics::at_pose(std::size_t k, std::size_t count, const double* jets, const double* loads,
                                      const Eigen::Vector3d& gravity, const double* wrenches, double& regularity) {
  VectorXd q[3];
  for (std::size_t c = 0; c < 3; ++c) {
    q[c].resize(machine_.dof());
    for (Index i = 0; i < q[c].size(); ++i) q[c](i) = jets[(3 * static_cast<std::size_t>(i) + c) * count + k];
  }
  evaluate(machine_, q[0].data(), q[1].data(), q[2].data(), state_);
  JointReactions out;
  out.singular = true;
  regularity = nan;
  if (state_.status != PM_OK) return out;
  // Several loads at one pose share what the pose alone says.
  if (!system_ || factorised_at_ != q[0]) {
    model_ = generic_model(machine_, state_);
    system_.emplace(machine_, state_, model_, frames_, length_);
    regularity_ = regularity_of(model_, machine_.topology().idle, length_);
    factorised_at_ = q[0];
  }
  regularity = regularity_;
  Loading loading;
  for (std::size_t c = 0; c < 6; ++c) loading.platform(static_cast<Index>(c)) = loads[c * count + k];
  loading.gravity = gravity;
  VectorXd required = inertial_wrenches(machine_, state_) - applied_wrenches(machine_, state_, loading);
  if (wrenches != nullptr) {
    const Eigen::Vector3d& p_O = state_.bodies[static_cast<std::size_t>(machine_.topology().platform)].origin;
    VectorXd more(required.size());  // about the bodies' own origins
    for (Index i = 0; i < more.size(); ++i) more(i) = wrenches[static_cast<std::size_t>(i) * count + k];
    for (Index at = 0; at < more.size(); at += 6)
      more.segment<3>(at + 3) += (p_O - state_.bodies[static_cast<std::size_t>(at / 6 + 1)].origin).cross(more.segment<3>(at));
    required -= more;
  }
  out = system_->reactions(required);
  out.singular = out.singular || regularity < linear::rank_tolerance;
  return out;
}

void DenseDynamics::solve(std::size_t count, const double* jets, const double* loads, const Eigen::Vector3d& gravity, MotionReactions& out,
                          bool reactions, const double* wrenches) {
  const std::size_t joints = machine_.topology().joints.size(), dof = static_cast<std::size_t>(machine_.dof());
  const std::size_t numbers = 6 * joints;
  out.actuator_forces.assign(dof * count, nan);
  out.regularity.assign(count, nan);
  out.joints.assign(reactions ? numbers * count : 0, nan);
  out.indeterminate.assign(reactions ? joints * count : 0, 0);
  out.stresses.clear();
  out.stress_count = 0;
  std::vector<MatrixXd> stresses(count);
  for (std::size_t k = 0; k < count; ++k) {
    const JointReactions r = at_pose(k, count, jets, loads, gravity, wrenches, out.regularity[k]);
    if (r.singular) continue;
    for (std::size_t i = 0; i < dof; ++i) out.actuator_forces[i * count + k] = r.actuator_forces(static_cast<Index>(i));
    if (!reactions) continue;
    for (std::size_t j = 0; j < joints; ++j) {
      for (std::size_t c = 0; c < 6; ++c) out.joints[(6 * j + c) * count + k] = r.joints[j](static_cast<Index>(c));
      out.indeterminate[j * count + k] = r.indeterminate[j];
    }
    stresses[k] = r.stresses.empty() ? MatrixXd(static_cast<Index>(numbers), 0) : orthonormal(r.stresses, length_);
    out.stress_count = std::max(out.stress_count, static_cast<int>(stresses[k].cols()));
  }
  const auto stress_count = static_cast<std::size_t>(out.stress_count);
  out.stresses.assign(stress_count * numbers * count, nan);
  for (std::size_t k = 0; k < count; ++k) {
    if (stresses[k].rows() == 0) continue;
    for (std::size_t s = 0; s < stress_count; ++s)  // one that this pose lacks is zero
      for (std::size_t i = 0; i < numbers; ++i) {
        const bool has = s < static_cast<std::size_t>(stresses[k].cols());
        const double unit = i % 6 < 3 ? 1.0 : length_;
        out.stresses[(s * numbers + i) * count + k] = has ? stresses[k](static_cast<Index>(i), static_cast<Index>(s)) * unit : 0.0;
      }
  }
}

}  // namespace pmreport::mechanics
