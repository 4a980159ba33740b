#include <core/mechanics/model/closed_form.hpp>

#include <core/assertion.hpp>
#include <core/linear/singular_values.hpp>
#include <core/linear/square.hpp>
#include <core/mechanics/model/overall_jacobian.hpp>

#include <algorithm>
#include <limits>

namespace pmreport::mechanics {

namespace {

// Singular values, zero where the matrix is not known.
Vector6d spectrum(const Matrix6d& g) { return g.allFinite() ? linear::singular_values(g) : Vector6d::Zero(); }
double over(double x, double y) { return y > 0 ? x / y : std::numeric_limits<double>::infinity(); }

}  // namespace

ClosedForm closed_form(const Machine& machine, const State& state, double length) {
  PMREPORT_ASSERT(state.status == PM_OK, "the state is that of an assembled pose");
  PMREPORT_ASSERT(length > 0, "the characteristic length is positive");
  double jets[108];
  ClosedForm c;
  (void)machine.jacobian(PM_JET, 1, state.placement_jets.data(), jets);  // NaN where it is not known
  for (int e = 0; e < 36; ++e) {
    c.jacobian(e / 6, e % 6) = jets[3 * e];
    c.jacobian_rate(e / 6, e % 6) = jets[3 * e + 1];
  }
  c.determinant = linear::determinant(c.jacobian);
  c.side = side_of(c.jacobian, length);
  const Vector6d sigma = spectrum(dimensionless(machine, c.jacobian, length));
  c.condition = over(sigma(0), sigma(5));
  const Matrix6d wrenches = unit_wrenches(c.jacobian, length);
  c.wrench_determinant = linear::determinant(wrenches);
  const Vector6d of_wrenches = spectrum(wrenches);
  c.wrench_condition = over(of_wrenches(0), of_wrenches(5));
  c.amplification = over(1, of_wrenches(5));
  return c;
}

Vector6d actuator_rates(const State& state) {
  Vector6d r = Vector6d::Zero();
  for (std::size_t i = 0; i < state.actuators.size(); ++i) r(static_cast<int>(i)) = state.actuators[i].rate;
  return r;
}

Vector6d actuator_accelerations(const State& state) {
  Vector6d r = Vector6d::Zero();
  for (std::size_t i = 0; i < state.actuators.size(); ++i) r(static_cast<int>(i)) = state.actuators[i].acceleration;
  return r;
}

Vector6d forward_velocity(const ClosedForm& c, const Vector6d& rates) { return linear::solution(c.jacobian, rates); }

Vector6d forward_acceleration(const ClosedForm& c, const Vector6d& accelerations, const Vector6d& twist) {
  return linear::solution(c.jacobian, accelerations - c.jacobian_rate * twist);
}

SourceDeviation source_deviation(const Machine& machine, const State& state) {
  const Topology& t = machine.topology();
  if (t.matrices.empty()) return {};
  const auto rates = [](const std::vector<Scalar>& of) {
    Eigen::VectorXd v(static_cast<Eigen::Index>(of.size()));
    for (std::size_t i = 0; i < of.size(); ++i) v(static_cast<Eigen::Index>(i)) = of[i].rate;
    return v;
  };
  const Eigen::VectorXd all[] = {rates(state.coordinates), rates(state.actuators),
                                 state.bodies[static_cast<std::size_t>(t.platform)].twist()};
  std::vector<double> q;
  for (const Scalar& c : state.coordinates) q.push_back(c.value);
  const std::vector<Eigen::MatrixXd> given = machine.matrices(q, machine.pose(q));
  SourceDeviation worst;
  if (given.empty()) worst.value = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < given.size(); ++i) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(t.matrices[i].rows);
    double scale = 1e-300;
    const auto add = [&](const Eigen::VectorXd& term) {
      sum += term;
      scale = std::max(scale, term.lpNorm<Eigen::Infinity>());
    };
    for (std::size_t k = 0; k < given.size(); ++k)
      if (t.matrices[k].relation == t.matrices[i].relation) add(given[k] * all[static_cast<std::size_t>(t.matrices[k].acts_on)]);
    if (t.matrices[i].gives != Rates::none) add(-all[static_cast<std::size_t>(t.matrices[i].gives)]);
    const double deviation = sum.lpNorm<Eigen::Infinity>() / scale;
    if (!(deviation <= worst.value) || worst.matrix < 0) worst = {deviation, static_cast<int>(i)};
  }
  return worst;
}

}  // namespace pmreport::mechanics
