#include <core/analysis/study/instant.hpp>

#include <limits>

namespace pmreport::analysis {

namespace {

// What the run computes, without the proofs: they are of its samples.
Asked asked_without_evidence(const scenario::Scenario& scenario) {
  Asked out = asked_by(scenario);
  out.displacement_evidence = out.velocity_evidence = out.acceleration_evidence = out.force_evidence = out.power_evidence = false;
  out.singularities = false;
  return out;
}

}  // namespace

Instant::Instant(const Analysis& a, double t) : scenario_(a.scenario()) {
  const Eigen::Index dof = a.machine().dof();
  Eigen::VectorXd value(dof), rate(dof), acceleration(dof);
  if (!a.trajectory().at(t, value.data(), rate.data(), acceleration.data())) return;
  trajectory_.time = {t};
  trajectory_.value = value.transpose(), trajectory_.rate = rate.transpose(), trajectory_.acceleration = acceleration.transpose();
  trajectory_.at = a.trajectory().at;
  const Eigen::Matrix<double, 6, 1> wrench = scenario_.load.at(t);
  scenario_.load.force = {wrench.head<3>()}, scenario_.load.moment = {wrench.tail<3>()};
  at_.emplace(scenario_, trajectory_, a.machine(), asked_without_evidence(scenario_), Progress{});
}

double Instant::value(const ColumnId& column) const {
  return at_ && at_->has(column) ? at_->column(column).front() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace pmreport::analysis
