#include <core/mechanics/conformance/dynamics_properties.hpp>

#include <core/linear/eigenvalues.hpp>
#include <core/mechanics/model/effort.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

using Eigen::VectorXd;

namespace {

// The larger of two, where a NaN is infinite.
double worse(double worst, double x) { return std::isnan(x) ? std::numeric_limits<double>::infinity() : std::max(worst, x); }

double coordinate_size(const Machine& machine, std::size_t coordinate, double length) {
  return mechanics::size_of(machine.topology().coordinates[coordinate].sense(), length);
}

}  // namespace

double mass_matrix_deviation(const Machine& machine, const State& state, const Tangent& tangent, double length) {
  SmallMatrix mass = equations_of_motion(machine, state, tangent, Eigen::Vector3d::Zero()).mass;
  for (int i = 0; i < machine.dof(); ++i) {
    const double size = coordinate_size(machine, static_cast<std::size_t>(i), length);
    mass.row(i) *= size, mass.col(i) *= size;
  }
  const double largest = mass.cwiseAbs().maxCoeff();
  if (largest == 0) return 0;
  constexpr double vanishing = 1e-12;  // some rounding of the sums; the least of a real mechanism is above 1e-6
  const bool positive = linear::symmetric_eigenvalues(mass).minCoeff() > vanishing * largest;
  return worse(positive ? 0 : 1, (mass - mass.transpose()).cwiseAbs().maxCoeff() / largest);
}

std::optional<double> energy_deviation(const Machine& machine, const State& state, const ForceShares& forces, const Loading& loading,
                                       double condition, double length) {
  const std::size_t dof = state.coordinates.size();
  const auto n = static_cast<Eigen::Index>(dof);
  VectorXd q(n), rate(n), acceleration(n);
  double speed = 0;  // in sizes a second
  for (std::size_t i = 0; i < dof; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const Scalar& c = state.coordinates[i];
    q(k) = c.value, rate(k) = c.rate, acceleration(k) = c.acceleration;
    const double size = coordinate_size(machine, i, length);
    speed = std::max({speed, std::abs(c.rate) / size, std::sqrt(std::abs(c.acceleration) / size)});
  }
  if (speed == 0) return 0;
  // At the edge of reach square roots end, sqrt(d) with d the way to go, and the truncation of differences of step h is some 10 (h / d)^8:
  // a twentieth of that way leaves 1e-9 at most.
  constexpr double clear = 20, least = 1e-5;
  const auto in_reach = [&](double t) {
    const VectorXd at = q + t * rate + 0.5 * t * t * acceleration;
    return machine.pose({at.data(), static_cast<std::size_t>(n)}).status == PM_OK;
  };
  double h = std::min(0.01, 0.3 / condition) / speed;
  while (!in_reach(-clear * h) || !in_reach(clear * h))
    if ((h /= 2) * speed < least) return std::nullopt;

  State then;
  bool reached = true;
  const auto energy = [&](double t) {
    const VectorXd at = q + t * rate + 0.5 * t * t * acceleration, its_rate = rate + t * acceleration;
    evaluate(machine, at.data(), its_rate.data(), acceleration.data(), then);
    if (then.status != PM_OK) reached = false;
    return reached ? kinetic_energy(machine, then) + potential_energy(machine, then, loading.gravity) : 0.0;
  };
  constexpr double weights[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
  // Without the kinetic and potential energy of the pose itself, which would only bring its roundings.
  double change = 0, stored = 0;
  for (int k = 1; k <= 4; ++k) {
    const double ahead = energy(k * h), behind = energy(-k * h);
    change += weights[k - 1] * (ahead - behind) / h;
    stored = std::max({stored, std::abs(ahead), std::abs(behind)});
  }
  if (!reached) return std::nullopt;

  const SmallVector total = forces.total();
  double power = 0, largest = std::max(std::abs(change), stored * speed);
  const auto add = [&](double p) { power += p, largest = worse(largest, std::abs(p)); };
  for (std::size_t i = 0; i < dof; ++i) add(total(static_cast<Eigen::Index>(i)) * state.actuators[i].rate);
  add(loading.platform.dot(state.bodies[static_cast<std::size_t>(machine.topology().platform)].twist()));
  return largest > 0 ? worse(0, std::abs(change - power) / largest) : 0;
}

FreeBodyDeviation free_body_deviation(const Machine& machine, const State& state, const JointFrames& frames, const ForceShares& forces,
                                      const Loading& loading, double length) {
  const JointReactions r = dense_reactions(machine, state, generic_model(machine, state), frames, loading, length);
  const SmallVector total = forces.total();
  FreeBodyDeviation d;
  d.forces = worse(0, (r.actuator_forces - total).lpNorm<Eigen::Infinity>() / std::max(1.0, total.lpNorm<Eigen::Infinity>()));
  d.balance = worse(0, r.residual);
  d.stresses = static_cast<int>(r.stresses.size());
  const VectorXd none = VectorXd::Zero(static_cast<Eigen::Index>(6 * (state.bodies.size() - 1))), idle = VectorXd::Zero(machine.dof());
  for (const auto& stress : r.stresses) d.stress = worse(d.stress, free_body_residual(machine, state, stress, idle, none, length));
  return d;
}

}  // namespace pmreport::mechanics
