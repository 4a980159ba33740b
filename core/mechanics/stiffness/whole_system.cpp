#include <core/mechanics/stiffness/whole_system.hpp>

#include <core/linear/least_norm.hpp>
#include <core/mechanics/model/constraint_scale.hpp>

#include <Eigen/Geometry>
#include <algorithm>

namespace pmreport::mechanics {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// What each multiplier of PHI exerts through its joint on body b, about the joint's centre; base axes. From the row that its body has.
Vector6d wrench_of_row(const Topology& t, const State& state, const GenericModel& model, Index row) {
  const int joint = model.joint_of_row[static_cast<std::size_t>(row)];
  const Joint& j = t.joints[static_cast<std::size_t>(joint)];
  const int body = j.b > 0 ? j.b : j.a;
  Vector6d w = model.constraints.block<1, 6>(row, 6 * body - 6).transpose();
  if (body != j.b) w = -w;
  w.tail<3>() -= (state.joints[static_cast<std::size_t>(joint)].centre - state.bodies[static_cast<std::size_t>(body)].origin)
                     .cross(Vector3d(w.head<3>()));
  return w;
}

}  // namespace

WholeSystem::WholeSystem(const SpringPlan& plan, const State& state) : platform_(plan.machine().topology().platform) {
  const Topology& t = plan.machine().topology();
  const GenericModel model = generic_model(plan.machine(), state);
  const Index rows = model.constraints.rows(), n = model.constraints.cols();
  multipliers_ = rows + model.actuation.rows();
  std::vector<double> placement(plan.machine().layout().size());
  for (std::size_t i = 0; i < placement.size(); ++i) placement[i] = state.placement_jets[3 * i];
  SpringPlan::AtPose parts;
  plan.at(placement.data(), 1, parts);

  // Forces in the springs by multipliers; base and platform are no bodies of this system that would give way.
  MatrixXd by_multiplier = MatrixXd::Zero(static_cast<Index>(parts.springs.size()), multipliers_);
  VectorXd c = VectorXd::Zero(by_multiplier.rows()), e = c;
  for (Index i = 0; i < by_multiplier.rows(); ++i) {
    const Spring& s = parts.springs[static_cast<std::size_t>(i)];
    if (s.of == Spring::Of::base || s.of == Spring::Of::platform) continue;
    c(i) = s.compliance, e(i) = s.shortens;
    if (s.of == Spring::Of::actuator) by_multiplier(i, rows + s.actuator) = 1;
    for (int k = s.first; k < s.first + s.terms; ++k) {
      const SpringTerm& term = parts.terms[static_cast<std::size_t>(k)];
      for (Index r = 0; r < rows; ++r)
        if (model.joint_of_row[static_cast<std::size_t>(r)] == term.joint)
          by_multiplier(i, r) += term.g.dot(wrench_of_row(t, state, model, r));
      if (term.actuator < 0) continue;
      const Vector3d& axis = state.joints[static_cast<std::size_t>(term.joint)].axis[0];
      const bool linear = t.actuators[static_cast<std::size_t>(term.actuator)].sense() == Sense::linear;
      by_multiplier(i, rows + term.actuator) += linear ? term.g.head<3>().dot(axis) : term.g.tail<3>().dot(axis);
    }
  }
  const MatrixXd form = by_multiplier.transpose() * c.asDiagonal() * by_multiplier;
  softness_ = std::max(form.diagonal().maxCoeff(), 1e-300);
  strain_ = by_multiplier.transpose() * e;
  system_ = MatrixXd::Zero(multipliers_ + n, multipliers_ + n);
  system_.topLeftCorner(multipliers_, multipliers_) = form / softness_;
  system_.block(0, multipliers_, rows, n) = model.constraints;
  system_.block(rows, multipliers_, model.actuation.rows(), n) = model.actuation;
  system_.bottomLeftCorner(n, multipliers_) = system_.topRightCorner(multipliers_, n).transpose();
}

MatrixXd WholeSystem::displacements(const MatrixXd& wrenches, bool strained) const {
  const Index n = system_.cols() - multipliers_;
  MatrixXd out(n, wrenches.cols());
  for (Index k = 0; k < wrenches.cols(); ++k) {
    VectorXd right = VectorXd::Zero(system_.rows());
    if (strained) right.head(multipliers_) = -strain_ / softness_;
    right.tail(n) = -wrenches.col(k);
    out.col(k) = softness_ * linear::least_norm_solution(system_, right, 1e-13).tail(n);
  }
  return out;
}

MatrixXd WholeSystem::under_unit_wrenches() const {
  MatrixXd units = MatrixXd::Zero(system_.cols() - multipliers_, 6);
  units.middleRows<6>(6 * platform_ - 6).setIdentity();
  return displacements(units);
}

}  // namespace pmreport::mechanics
