#include <core/mechanics/forward_dynamics/forced_motion.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <core/linear/square.hpp>
#include <core/mechanics/dynamics/virtual_work.hpp>

#include <fmt/format.h>

#include <cmath>

namespace pmreport::mechanics {

namespace {

// Of a pivot of the mass matrix with unit diagonal: smaller ones are rounding.
constexpr double no_inertia = 1e-13;

// Square roots of the diagonal of M: sqrt(kg), or sqrt(kg m^2) of an angle.
SmallVector inertia_scale(const Machine& machine, const SmallMatrix& mass) {
  SmallVector scale(mass.rows());
  for (int i = 0; i < mass.rows(); ++i) {
    if (!(mass(i, i) > 0))
      throw NoMotion(Outcome::failed,
                     fmt::format("nothing that has mass moves with {}", machine.topology().coordinates[static_cast<std::size_t>(i)].name));
    scale(i) = std::sqrt(mass(i, i));
  }
  return scale;
}

}  // namespace

ForcedMotion::ForcedMotion(const Machine& machine, const ForwardProblem& problem)
    : machine_(machine), problem_(problem), none_(SmallVector::Zero(machine.dof())), forces_(machine.dof()) {}

void ForcedMotion::place(const SmallVector& q, const SmallVector& rate) {
  constexpr double beyond = 1e12;  // [m], [rad], and a second: products of jets overflow long after, but mean nothing here already
  const auto moves = [](const SmallVector& x) { return x.cwiseAbs().maxCoeff() < beyond; };
  if (!q.allFinite() || !rate.allFinite() || !moves(q) || !moves(rate))
    throw NoMotion(Outcome::failed, "the motion grows beyond the range of numbers");
  evaluate(machine_, q.data(), rate.data(), none_.data(), state_);
  if (state_.status == PM_UNREACHABLE || state_.status == PM_SINGULAR) throw NoMotion(Outcome::unreachable, state_.why);
  if (state_.status != PM_OK) throw MechanismError(PM_FAILED, state_.why);
}

// M with unit diagonal, S = D^-1 M D^-1, compares coordinates of any units; q'' = D^-1 S^-1 D^-1 (what drives).
ForcedMotion::Answer ForcedMotion::at(double t, const SmallVector& q, const SmallVector& rate) {
  ++evaluations_;
  place(q, rate);
  const Tangent k = tangent(machine_, state_);
  if (!k.by_coordinates) {
    const auto fault = chart_fault(machine_, q, characteristic_length(machine_));
    throw NoMotion(Outcome::failed, (fault ? in_words(machine_, *fault) : "the coordinates are singular there") +
                                        std::string("; turn the platform's own axes, so that it moves at other angles"));
  }
  const EquationsOfMotion e = equations_of_motion(machine_, state_, k, problem_.gravity);

  forces_.setZero();
  problem_.actuator_forces(t, state_.actuators, forces_.data());
  for (int i = 0; i < forces_.size(); ++i)
    if (!std::isfinite(forces_(i)))
      throw NoMotion(Outcome::failed,
                     fmt::format("the force of {} has no finite value", machine_.topology().actuators[static_cast<std::size_t>(i)].name));
  SmallVector drive = k.actuators.transpose() * forces_;
  if (problem_.load) {
    const Vector6d load = problem_.load(t);
    if (!load.allFinite()) throw NoMotion(Outcome::failed, "the load has no finite value");
    drive += k.bodies.middleRows<6>(6 * machine_.topology().platform - 6).transpose() * load;
  }

  const SmallVector scale = inertia_scale(machine_, e.mass);
  const SmallMatrix scaled = scale.cwiseInverse().asDiagonal() * e.mass * scale.cwiseInverse().asDiagonal();
  const SmallVector right_side = (drive - e.coriolis - e.gravity).cwiseQuotient(scale);
  const std::optional<SmallVector> solved = linear::solution_of_positive_definite(scaled, right_side, no_inertia);
  if (!solved) throw NoMotion(Outcome::failed, "the mass matrix is singular: there the coordinates do not tell the motion of the masses");
  Answer out;
  out.acceleration = solved->cwiseQuotient(scale);
  out.power = drive.dot(rate);
  if (!out.acceleration.allFinite()) throw NoMotion(Outcome::failed, "the accelerations are beyond the range of numbers");
  return out;
}

ForcedMotion::Energy ForcedMotion::energy(const SmallVector& q, const SmallVector& rate) {
  place(q, rate);
  return {kinetic_energy(machine_, state_), potential_energy(machine_, state_, problem_.gravity)};
}

}  // namespace pmreport::mechanics
