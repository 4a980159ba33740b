#include <core/analysis/samples/sample_work.hpp>

#include <core/analysis/columns.hpp>
#include <core/analysis/conditioning.hpp>
#include <core/analysis/transmission/transmission_numbers.hpp>
#include <core/mechanics/model/differences.hpp>
#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/joint_motion.hpp>
#include <core/mechanics/model/tangent.hpp>
#include <core/mechanics/singularity/end_of_reach.hpp>
#include <core/mechanics/statics/statics.hpp>
#include <core/text/units.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <core/mechanics/dynamics/virtual_work.hpp>
#include <limits>

namespace pmreport::analysis {

using mechanics::Outcome;
using mechanics::Vector6d;

namespace {

double largest_of(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0; }

}  // namespace

Outcome SampleWork::run(int sample, int previous, Row& row, const Put& put) {
  const mechanics::Trajectory& motion = trajectory_;
  wrenches_ = {};
  const Eigen::VectorXd q = motion.value.row(sample), rate = motion.rate.row(sample), acceleration = motion.acceleration.row(sample);
  if (!q.allFinite()) {
    state_.why = "the motion " + motion.ending;
    return Outcome::unreachable;
  }
  evaluate(machine_, q.data(), rate.data(), acceleration.data(), state_);
  if (state_.status == PM_UNREACHABLE) return Outcome::unreachable;
  if (state_.status == PM_SINGULAR) {  // without rates, at the end of reach, or not even a pose that the geometry can express
    const bool exists = machine_.pose({q.data(), static_cast<std::size_t>(q.size())}).status == PM_OK;
    return exists ? Outcome::singular : Outcome::unreachable;
  }
  if (state_.status != PM_OK) return Outcome::failed;

  const mechanics::ClosedForm c = closed_form(machine_, state_, length_);
  wrenches_ = {c.side, c.wrench_determinant, c.wrench_condition, c.amplification};
  const bool rates = asked_.velocity_evidence || asked_.acceleration_evidence;
  const mechanics::GenericModel model = rates || asked_.statics ? generic_model(machine_, state_) : mechanics::GenericModel{};
  kinematics(put, c);
  if (transmission_ != nullptr) transmission(put);
  if (asked_.displacement_evidence) {
    const mechanics::ClosureError e = closure_.error(state_.bodies);
    set(row, Measure::gap, e.gap);
    set(row, Measure::misalignment, e.misalignment);
  }
  if (rates) prove_rates(row, c, model);
  if (asked_.displacement_evidence && wrenches_.are_comparable() && c.condition < comparable)
    round_trip(sample, previous, c.condition, row);
  if (wrenches_.are_singular()) {
    state_.why =
        fmt::format("the wrenches on the platform depend on one another (condition number {})", format_number(c.wrench_condition, 3));
    return Outcome::singular;
  }
  if (asked_.statics) statics(sample, row, put, c, model);
  return Outcome::good;
}

void SampleWork::kinematics(const Put& put, const mechanics::ClosedForm& c) {
  const Topology& t = machine_.topology();
  const auto all = [&](const auto& declared, const std::vector<mechanics::Scalar>& values) {
    for (std::size_t i = 0; i < declared.size(); ++i) {
      put(column_of(declared[i], OfMotion::value), values[i].value);
      put(column_of(declared[i], OfMotion::rate), values[i].rate);
      put(column_of(declared[i], OfMotion::acceleration), values[i].acceleration);
    }
  };
  all(t.coordinates, state_.coordinates);
  all(t.derived, state_.derived);
  all(t.actuators, state_.actuators);
  const auto vector = [&](OfPlatform what, const Eigen::Vector3d& value) {
    for (std::size_t axis = 0; axis < 3; ++axis) put(column_of(what, axis), value(static_cast<Eigen::Index>(axis)));
  };
  vector(OfPlatform::velocity, platform().velocity);
  vector(OfPlatform::angular_velocity, platform().angular_velocity);
  vector(OfPlatform::acceleration, platform().acceleration);
  vector(OfPlatform::angular_acceleration, platform().angular_acceleration);
  if (!t.readings.empty()) {
    std::vector<double> q;
    for (const mechanics::Scalar& x : state_.coordinates) q.push_back(x.value);
    const std::vector<double> readings = machine_.readings(q, machine_.pose(q));
    for (std::size_t i = 0; i < readings.size(); ++i) put(column_of(t.readings[i]), readings[i]);
  }
  put(column_of(OfMachine::determinant), c.determinant);
  put(column_of(OfMachine::condition), c.condition);
  for (std::size_t i = 0; i < t.joints.size(); ++i) {
    const std::vector<double> motion = closure_.motion(state_.bodies, static_cast<int>(i));
    for (std::size_t n = 0; n < motion.size(); ++n)
      if (mechanics::is_told(t.joints[i], n)) put(joint_column(t.joints[i], n), motion[n]);
  }
}

void SampleWork::transmission(const Put& put) {
  std::vector<double> q;
  for (const mechanics::Scalar& x : state_.coordinates) q.push_back(x.value);
  transmission_numbers(*transmission_, q, transmission_work_, transmission_numbers_);
  for (std::size_t i = 0; i < transmission_columns_.size(); ++i)
    if (std::isfinite(transmission_numbers_[i])) put(transmission_columns_[i], transmission_numbers_[i]);
}

// Of velocities and accelerations together: they share what they are made of.
void SampleWork::prove_rates(Row& row, const mechanics::ClosedForm& c, const mechanics::GenericModel& model) {
  const Eigen::VectorXd v = stacked_twists(state_), a = stacked_twist_rates(state_);
  const double v_scale = largest_of(v), a_scale = std::max(largest_of(a), v_scale * v_scale);
  const Vector6d twist = platform().twist(), twist_rate = platform().twist_rate();
  const Vector6d rates = actuator_rates(state_), accelerations = actuator_accelerations(state_);
  set(row, Measure::velocity, relative(largest_of(model.constraints * v), v_scale));
  set(row, Measure::acceleration, relative(largest_of(model.constraints * a + model.bias), a_scale));
  set(row, Measure::jacobian, relative(largest_of(c.jacobian * twist - rates), v_scale));
  set(row, Measure::jacobian_rate, relative(largest_of(c.jacobian * twist_rate + c.jacobian_rate * twist - accelerations), a_scale));
  if (wrenches_.are_comparable()) {
    set(row, Measure::forward_velocity, relative(largest_of(forward_velocity(c, rates) - twist), v_scale));
    set(row, Measure::forward_acceleration, relative(largest_of(forward_acceleration(c, accelerations, twist) - twist_rate), a_scale));
  }
  if (!machine_.topology().matrices.empty()) set(row, Measure::source, source_deviation(machine_, state_).value);
  const mechanics::Deviation d = jets_against_differences(machine_, state_);
  if (d.reachable) {
    set(row, Measure::difference_rate, d.rate, d.rate_error);
    set(row, Measure::difference_acceleration, d.acceleration, d.acceleration_error);
  }
}

// The guess lies towards the neighbouring sample, at most a tenth of the characteristic length, or 0.1 rad, away; nearer next to a singular
// pose, beyond which another assembly mode has the same actuator values, and next to the end of reach. Where that leaves no way to go, or
// the coordinates themselves are singular, nothing is compared.
void SampleWork::round_trip(int sample, int previous, double condition, Row& row) {
  constexpr double least_way = 1e-5;  // of the size: a thousand times what the claim lets the answer be off
  const auto unit = [&](int i) {
    return mechanics::size_of(machine_.topology().coordinates[static_cast<std::size_t>(i)].sense(), length_);
  };
  const Eigen::VectorXd q = trajectory_.value.row(sample);
  Eigen::VectorXd neighbour = trajectory_.value.row(previous);
  if (!neighbour.allFinite()) neighbour = q;
  double allowed = std::min(0.1, 1 / condition);
  if (const auto end = mechanics::end_of_reach(machine_, q, length_)) allowed = std::min(allowed, 0.25 * end->distance / length_);
  if (allowed < least_way || mechanics::chart_fault(machine_, q, length_)) return;
  double far = 0;
  for (int i = 0; i < q.size(); ++i) far = std::max(far, std::abs(neighbour(i) - q(i)) / (allowed * unit(i)));
  const Eigen::VectorXd guess = q + (neighbour - q) / std::max(far, 1.0);
  mechanics::SmallVector l(machine_.dof());
  for (int i = 0; i < q.size(); ++i) l(i) = state_.actuators[static_cast<std::size_t>(i)].value;
  const mechanics::ForwardSolution s = forward_.solve(l, guess);
  double worst = s.outcome == Outcome::good ? 0 : std::numeric_limits<double>::infinity();
  for (int i = 0; i < q.size(); ++i) worst = std::max(worst, std::abs(s.coordinates(i) - q(i)) / unit(i));
  set(row, Measure::round_trip, worst);
}

void SampleWork::statics(int sample, Row& row, const Put& put, const mechanics::ClosedForm& c, const mechanics::GenericModel& model) {
  const Topology& t = machine_.topology();
  const scenario::Load& load = load_;
  const Eigen::VectorXd weight = weights(machine_, state_, load.gravity), twists = stacked_twists(state_);
  Vector6d wrench;
  wrench << load.force[static_cast<std::size_t>(sample)], load.moment[static_cast<std::size_t>(sample)];

  // Load by G; weights by virtual work. What the limbs exert on the platform balances its load and its own weight.
  Eigen::VectorXd forces = closed_statics(c, wrench).head(machine_.dof());
  if (!load.gravity.isZero()) forces += weight_forces(machine_, state_, load.gravity);
  const Vector6d on_platform = closed_statics(c, wrench + weight.segment<6>(6 * t.platform - 6));
  for (int i = 0; i < machine_.dof(); ++i) put(column_of(t.actuators[static_cast<std::size_t>(i)], OfActuator::static_force), forces(i));
  for (std::size_t i = 0; i < t.constraints.size(); ++i)
    put(column_of(t.constraints[i]), on_platform(machine_.dof() + static_cast<int>(i)));

  if (wrenches_.are_comparable()) {
    Eigen::VectorXd wrenches = weight;
    wrenches.segment<6>(6 * t.platform - 6) += wrench;
    const mechanics::GenericStatics g = generic_statics(model, wrenches);
    set(row, Measure::statics, relative(largest_of(g.actuator_forces - forces), std::max(largest_of(forces), largest_of(wrenches))));
    set(row, Measure::equilibrium, g.residual);
  }
  const Vector6d twist = platform().twist();
  double power = wrench.dot(twist) + weight.dot(twists);
  double scale = std::max(largest_of(wrench.cwiseProduct(twist)), largest_of(weight.cwiseProduct(twists)));
  for (int i = 0; i < machine_.dof(); ++i) {
    const double p = forces(i) * state_.actuators[static_cast<std::size_t>(i)].rate;
    power += p;
    scale = std::max(scale, std::abs(p));
  }
  set(row, Measure::power, relative(std::abs(power), scale));
}

}  // namespace pmreport::analysis
