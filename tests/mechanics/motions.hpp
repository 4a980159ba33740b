// Random motions of a mechanism, and the inverse dynamics of one held against the system over all its bodies.
#pragma once

#include <core/mechanics/mobility/mobility.hpp>
#include <core/mechanics/model/generic_model.hpp>
#include <core/mechanics/model/random_poses.hpp>
#include <core/mechanics/reactions/inverse_dynamics.hpp>

#include <catch2/catch.hpp>
#include <random>

namespace pmreport::test {

using mechanics::Machine;
using mechanics::MotionReactions;
using mechanics::Vector6d;

// Poses with rates, accelerations and loads, laid out as InverseDynamics wants them.
struct LoadedMotion {
  std::size_t count = 0, dof = 0;
  std::vector<double> jets, loads;
  Eigen::Vector3d gravity{1, 2, -9.81};

  // A pose as it stands in a motion of its own.
  LoadedMotion at(std::size_t k) const { return part(k, 1); }
  LoadedMotion part(std::size_t first, std::size_t poses) const {
    LoadedMotion out{poses, dof, {}, {}, gravity};
    for (const auto& [from, to] : {std::pair{&jets, &out.jets}, std::pair{&loads, &out.loads}})
      for (std::size_t i = 0; i < from->size() / count; ++i)
        for (std::size_t k = 0; k < poses; ++k) to->push_back((*from)[i * count + first + k]);
    return out;
  }
  mechanics::State state(const Machine& machine, std::size_t k) const {
    Eigen::VectorXd q[3];
    for (std::size_t c = 0; c < 3; ++c) {
      q[c].resize(machine.dof());
      for (std::size_t i = 0; i < dof; ++i) q[c](static_cast<int>(i)) = jets[(3 * i + c) * count + k];
    }
    mechanics::State s;
    evaluate(machine, q[0].data(), q[1].data(), q[2].data(), s);
    return s;
  }
  mechanics::Loading loading(std::size_t k) const {
    mechanics::Loading l;
    for (std::size_t c = 0; c < 6; ++c) l.platform(static_cast<int>(c)) = loads[c * count + k];
    l.gravity = gravity;
    return l;
  }
};

// Poses in the box of the coordinates, rates to 1 and accelerations to 5 a second (squared), loads to 100 N and 100 N m.
inline LoadedMotion random_loaded_motion(const Machine& machine, int poses, std::uint64_t seed) {
  const std::vector<Eigen::VectorXd> q = mechanics::random_poses(machine, poses, seed);
  REQUIRE(q.size() == static_cast<std::size_t>(poses));
  LoadedMotion m{q.size(), static_cast<std::size_t>(machine.dof()), {}, {}};
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> symmetric(-1, 1);
  for (int i = 0; i < machine.dof(); ++i)
    for (int c = 0; c < 3; ++c)
      for (const Eigen::VectorXd& pose : q) m.jets.push_back(c == 0 ? pose(i) : c == 1 ? symmetric(random) : 5 * symmetric(random));
  for (std::size_t i = 0; i < 6 * m.count; ++i) m.loads.push_back(100 * symmetric(random));
  return m;
}

inline MotionReactions solve(mechanics::InverseDynamics& dynamics, const LoadedMotion& m, bool reactions = true) {
  MotionReactions out;
  dynamics.solve(m.count, m.jets.data(), m.loads.data(), m.gravity, out, reactions);
  return out;
}

// Wrenches of all joints at pose k of `count`; of the reactions, or of one stress.
inline std::vector<Vector6d> wrenches(const std::vector<double>& numbers, std::size_t joints, std::size_t count, std::size_t k,
                                      std::size_t which = 0) {
  std::vector<Vector6d> out(joints);
  for (std::size_t j = 0; j < joints; ++j)
    for (std::size_t c = 0; c < 6; ++c) out[j](static_cast<int>(c)) = numbers[(6 * (which * joints + j) + c) * count + k];
  return out;
}

inline double inner(const std::vector<Vector6d>& a, const std::vector<Vector6d>& b, double length) {
  double sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    sum += a[j].head<3>().dot(b[j].head<3>()) + a[j].tail<3>().dot(b[j].tail<3>()) / (length * length);
  return sum;
}

// Two ways to the same numbers, of which neither loses more digits than a pose of regularity 1e-4 takes: rounding (1e-16) times that.
inline constexpr double agreement = 1e-11;

inline void require_same_as_dense(const Machine& machine, int poses, std::uint64_t seed) {
  using namespace mechanics;
  const LoadedMotion motion = random_loaded_motion(machine, poses, seed);
  InverseDynamics dynamics(machine);
  const MotionReactions seen = solve(dynamics, motion);
  const JointFrames frames(machine);
  const double length = characteristic_length(machine);
  const std::size_t joints = machine.topology().joints.size();
  double forces = 0, reactions = 0, residual = 0, stress_residual = 0, orthonormal = 0;
  for (std::size_t k = 0; k < motion.count; ++k) {
    const State state = motion.state(machine, k);
    const JointReactions dense = dense_reactions(machine, state, generic_model(machine, state), frames, motion.loading(k), length);
    INFO("pose " << k << " of seed " << seed);
    REQUIRE_FALSE(dense.singular);
    REQUIRE(seen.regularity[k] > 1e-4);
    REQUIRE(static_cast<std::size_t>(seen.stress_count) == dense.stresses.size());
    const std::vector<Vector6d> mine = wrenches(seen.joints, joints, motion.count, k);
    Eigen::VectorXd tau(machine.dof());
    for (std::size_t i = 0; i < motion.dof; ++i) tau(static_cast<int>(i)) = seen.actuator_forces[i * motion.count + k];

    double largest = 0;
    for (const Vector6d& w : dense.joints) largest = std::max(largest, w.lpNorm<Eigen::Infinity>());
    const auto worse = [](double& worst, double deviation) { worst = deviation <= worst ? worst : deviation; };  // a NaN is worse
    worse(forces, (tau - dense.actuator_forces).lpNorm<Eigen::Infinity>() / largest);
    for (std::size_t j = 0; j < joints; ++j) {
      worse(reactions, (mine[j] - dense.joints[j]).lpNorm<Eigen::Infinity>() / largest);
      CHECK(seen.indeterminate[j * motion.count + k] == dense.indeterminate[j]);
    }
    const Eigen::VectorXd required = inertial_wrenches(machine, state) - applied_wrenches(machine, state, motion.loading(k));
    worse(residual, free_body_residual(machine, state, mine, tau, required, length));
    for (std::size_t s = 0; s < dense.stresses.size(); ++s) {
      const auto stress = wrenches(seen.stresses, joints, motion.count, k, s);
      worse(stress_residual, free_body_residual(machine, state, stress, 0 * tau, 0 * required, length));
      worse(orthonormal, std::abs(inner(stress, mine, length)) / largest);
      for (std::size_t other = 0; other <= s; ++other) {
        const auto before = wrenches(seen.stresses, joints, motion.count, k, other);
        worse(orthonormal, std::abs(inner(stress, before, length) - (s == other ? 1 : 0)));
      }
    }
  }
  CHECK(forces < agreement);
  CHECK(reactions < agreement);
  CHECK(residual < agreement);
  CHECK(stress_residual < agreement);
  CHECK(orthonormal < agreement);
}

}  // namespace pmreport::test
