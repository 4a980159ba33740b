// States and loads in which a mechanism is judged.
#pragma once

#include <core/mechanics/dynamics/momentum.hpp>
#include <core/mechanics/model/state.hpp>

#include <random>

namespace pmreport::judges {

// Brisk enough for inertia to matter beside gravity: in the box of the coordinates, which it crosses at a rate of up to a box a second,
// with accelerations of up to ten times that. Poses out of reach are drawn again.
inline mechanics::State random_state(const mechanics::Machine& machine, std::mt19937_64& random) {
  std::uniform_real_distribution<double> symmetric(-1, 1);
  const auto dof = static_cast<std::size_t>(machine.dof());
  std::vector<double> q(dof), rate(dof), acceleration(dof);
  mechanics::State state;
  do {
    for (std::size_t i = 0; i < dof; ++i) {
      const Range& box = machine.topology().coordinates[i].box;
      const double half = 0.5 * (box.max - box.min);
      q[i] = box.min + half * (1 + symmetric(random));
      rate[i] = 2 * half * symmetric(random);
      acceleration[i] = 20 * half * symmetric(random);
    }
    mechanics::evaluate(machine, q.data(), rate.data(), acceleration.data(), state);
  } while (state.status == PM_UNREACHABLE);
  return state;
}

// Forces of up to 100 N, moments of up to 10 N m, and the Earth's gravity in any direction.
inline mechanics::Loading random_loading(std::mt19937_64& random) {
  std::uniform_real_distribution<double> symmetric(-1, 1);
  std::normal_distribution<double> normal;
  mechanics::Loading loading;
  for (int i = 0; i < 6; ++i) loading.platform(i) = (i < 3 ? 100 : 10) * symmetric(random);
  for (int i = 0; i < 3; ++i) loading.gravity(i) = normal(random);
  loading.gravity *= 9.81 / loading.gravity.norm();
  return loading;
}

}  // namespace pmreport::judges
