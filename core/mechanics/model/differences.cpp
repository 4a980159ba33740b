#include <core/mechanics/model/differences.hpp>

#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pmreport::mechanics {

namespace {
using Extended = long double;

void split(Extended x, double* out) {
  out[0] = static_cast<double>(x);
  out[1] = static_cast<double>(x - static_cast<Extended>(out[0]));
}
Extended join(const double* in) { return static_cast<Extended>(in[0]) + static_cast<Extended>(in[1]); }
}  // namespace

Deviation jets_against_differences(const Machine& machine, const State& state) {
  // Central differences of eighth order at -4 .. 4 steps.
  static constexpr std::array<Extended, 4> first{4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
  static constexpr std::array<Extended, 4> second{8.0L / 5, -1.0L / 5, 8.0L / 315, -1.0L / 560};
  static constexpr Extended middle = -205.0L / 72;

  const double length = characteristic_length(machine);
  const std::size_t dof = state.coordinates.size(), size = machine.layout().size();
  double speed = 0;  // of the coordinates, in sizes a second
  for (std::size_t i = 0; i < dof; ++i) {
    const double unit = size_of(machine.topology().coordinates[i].sense(), length);
    speed = std::max({speed, std::abs(state.coordinates[i].rate) / unit, std::sqrt(std::abs(state.coordinates[i].acceleration) / unit)});
  }
  Deviation d;
  if (speed == 0) return d;
  const Extended step = 1e-3L / speed;

  std::vector<double> q(2 * dof), placement(2 * size);
  std::vector<std::array<Extended, 9>> samples(size);
  for (int k = -4; k <= 4; ++k) {
    const Extended s = step * k;
    for (std::size_t i = 0; i < dof; ++i) {
      const Scalar& c = state.coordinates[i];
      split(static_cast<Extended>(c.value) + s * (static_cast<Extended>(c.rate) + s * static_cast<Extended>(c.acceleration) / 2),
            &q[2 * i]);
    }
    if (machine.place(PM_EXTENDED, 1, q.data(), placement.data()) != PM_OK) {
      d.reachable = false;
      return d;
    }
    for (std::size_t i = 0; i < size; ++i) {
      const Extended x = samples[i][static_cast<std::size_t>(k + 4)] = join(&placement[2 * i]);
      if (!std::isfinite(x)) {  // a maximum would pass over it
        d.rate = d.acceleration = std::numeric_limits<double>::infinity();
        return d;
      }
    }
  }
  double rate_scale = 0, acceleration_scale = 0;
  for (std::size_t i = 1; i < size; ++i) {  // 0 is the reach, a margin without meaning of its own
    const auto& x = samples[i];
    Extended rate = 0, acceleration = middle * x[4];
    for (std::size_t k = 1; k <= 4; ++k) {
      rate += first[k - 1] * (x[4 + k] - x[4 - k]);
      acceleration += second[k - 1] * (x[4 + k] + x[4 - k]);
    }
    rate /= step;
    acceleration /= step * step;
    rate_scale = std::max(rate_scale, std::abs(static_cast<double>(rate)));
    acceleration_scale = std::max(acceleration_scale, std::abs(static_cast<double>(acceleration)));
    d.rate = std::max(d.rate, std::abs(static_cast<double>(rate - static_cast<Extended>(state.placement_jets[3 * i + 1]))));
    d.acceleration =
        std::max(d.acceleration, std::abs(static_cast<double>(acceleration - static_cast<Extended>(state.placement_jets[3 * i + 2]))));
  }
  // What the motion brings about: accelerations also from rates alone.
  acceleration_scale = std::max(acceleration_scale, length * speed * speed);
  rate_scale = std::max(rate_scale, length * speed);
  d.rate /= rate_scale;
  d.acceleration /= acceleration_scale;
  return d;
}

}  // namespace pmreport::mechanics
