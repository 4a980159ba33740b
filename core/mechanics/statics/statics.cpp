#include <core/mechanics/statics/statics.hpp>

#include <core/assertion.hpp>
#include <core/linear/least_norm.hpp>
#include <core/linear/square.hpp>

#include <Eigen/Geometry>

namespace pmreport::mechanics {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// (1).
Vector6d closed_statics(const ClosedForm& c, const Vector6d& load) { return -linear::solution_of_transpose(c.jacobian, load); }

// (2): PHI^T and B^T side by side.
GenericStatics generic_statics(const GenericModel& model, const VectorXd& wrenches) {
  PMREPORT_ASSERT(wrenches.size() == model.constraints.cols(), "there is a wrench for every moving body");
  const int rows = static_cast<int>(model.constraints.rows()), m = static_cast<int>(model.actuation.rows());
  MatrixXd system(model.constraints.cols(), rows + m);
  system << model.constraints.transpose(), model.actuation.transpose();
  const VectorXd x = linear::least_norm_solution(system, -wrenches);
  const double largest = wrenches.lpNorm<Eigen::Infinity>();
  return {x.head(rows), x.tail(m), largest > 0 ? (system * x + wrenches).lpNorm<Eigen::Infinity>() / largest : 0.0};
}

GenericStatics generic_statics(const Machine& machine, const GenericModel& model, const Vector6d& load) {
  VectorXd w = VectorXd::Zero(model.constraints.cols());
  w.segment<6>(6 * machine.topology().platform - 6) = load;
  return generic_statics(model, w);
}

VectorXd weights(const Machine& machine, const State& state, const Vector3d& gravity) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  VectorXd w(6 * (static_cast<int>(state.bodies.size()) - 1));
  for (std::size_t i = 1; i < state.bodies.size(); ++i) {
    const Inertia& body = machine.topology().bodies[i].inertia;
    const Vector3d p_AC = state.bodies[i].rotation * body.centre, force = body.mass * gravity;
    w.segment<6>(6 * static_cast<int>(i) - 6) << force, p_AC.cross(force);
  }
  return w;
}

}  // namespace pmreport::mechanics
