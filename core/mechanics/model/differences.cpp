#include <core/mechanics/model/differences.hpp>

#include <core/mechanics/model/effort.hpp>
#include <core/mechanics/model/generic_model.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace pmreport::mechanics {

namespace {
using Extended = long double;

void split(Extended x, double* out) {
  out[0] = static_cast<double>(x);
  out[1] = static_cast<double>(x - static_cast<Extended>(out[0]));
}
Extended join(const double* in) { return static_cast<Extended>(in[0]) + static_cast<Extended>(in[1]); }

// Derivatives along the motion by differences, at one step.
struct Differences {
  std::vector<Extended> rate, acceleration;
  double rate_error = 0, acceleration_error = 0;  // largest of any scalar [its unit]
};

class Stencil {
 public:
  Stencil(const Machine& machine, const State& state)
      : machine_(machine),
        state_(state),
        q_(2 * state.coordinates.size()),
        placement_(2 * machine.layout().size()),
        samples_(machine.layout().size()) {}

  // Nothing where a point of the stencil cannot be assembled, or is not finite.
  std::optional<Differences> at(Extended step) {
    // Central differences of eighth and of sixth order, at -4 .. 4 steps.
    static constexpr std::array<Extended, 4> first{4.0L / 5, -1.0L / 5, 4.0L / 105, -1.0L / 280};
    static constexpr std::array<Extended, 4> second{8.0L / 5, -1.0L / 5, 8.0L / 315, -1.0L / 560};
    static constexpr std::array<Extended, 4> lower_first{3.0L / 4, -3.0L / 20, 1.0L / 60, 0};
    static constexpr std::array<Extended, 4> lower_second{3.0L / 2, -3.0L / 20, 1.0L / 90, 0};
    static constexpr Extended middle = -205.0L / 72, lower_middle = -49.0L / 18;
    if (!sample(step)) return std::nullopt;
    Differences out;
    constexpr Extended epsilon = std::numeric_limits<Extended>::epsilon();
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const auto& x = samples_[i];
      Extended rate = 0, lower_rate = 0, acceleration = middle * x[4], lower_acceleration = lower_middle * x[4];
      for (std::size_t k = 1; k <= 4; ++k) {
        const Extended odd = x[4 + k] - x[4 - k], even = x[4 + k] + x[4 - k];
        rate += first[k - 1] * odd, lower_rate += lower_first[k - 1] * odd;
        acceleration += second[k - 1] * even, lower_acceleration += lower_second[k - 1] * even;
      }
      out.rate.push_back(rate / step), out.acceleration.push_back(acceleration / (step * step));
      if (i == 0) continue;  // the reach, a margin without meaning of its own
      const Extended rounding = 4 * epsilon * std::abs(x[4]);
      out.rate_error = std::max(out.rate_error, static_cast<double>((std::abs(rate - lower_rate) + rounding) / step));
      out.acceleration_error =
          std::max(out.acceleration_error, static_cast<double>((std::abs(acceleration - lower_acceleration) + rounding) / (step * step)));
    }
    return out;
  }

 private:
  bool sample(Extended step) {
    for (int k = -4; k <= 4; ++k) {
      const Extended s = step * k;
      for (std::size_t i = 0; i < state_.coordinates.size(); ++i) {
        const Scalar& c = state_.coordinates[i];
        split(static_cast<Extended>(c.value) + s * (static_cast<Extended>(c.rate) + s * static_cast<Extended>(c.acceleration) / 2),
              &q_[2 * i]);
      }
      if (machine_.place(PM_EXTENDED, 1, q_.data(), placement_.data()) != PM_OK) return false;
      for (std::size_t i = 0; i < samples_.size(); ++i) samples_[i][static_cast<std::size_t>(k + 4)] = join(&placement_[2 * i]);
    }
    return true;
  }

  const Machine& machine_;
  const State& state_;
  std::vector<double> q_, placement_;
  std::vector<std::array<Extended, 9>> samples_;
};

// The largest number among the places of joints, all within a few of it from one another [m]: what positions are rounded by.
double extent(const Machine& machine, const State& state) {
  double out = 0;
  for (int j = 0; j < static_cast<int>(machine.topology().joints.size()); ++j)
    for (std::size_t axis = 0; axis < 3; ++axis)
      out = std::max(out, std::abs(state.placement_jets[3 * (machine.layout().joint(j) + axis)]));
  return out;
}

// Largest change of the rates, and of the accelerations, of a placement when the coordinates move by as many roundings of what they are
// added to as the few dozen operations from a coordinate to a number of the placement make.
std::pair<double, double> rounding_of_jets(const Machine& machine, const State& state, double length) {
  const std::size_t dof = state.coordinates.size(), size = machine.layout().size();
  constexpr double roundings = 64;
  const double reach = std::max(length, extent(machine, state));
  std::vector<double> moved = state.coordinate_jets, jets(3 * size);
  std::pair<double, double> out{0, 0};
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < dof; ++i)
      moved[3 * i] = state.coordinate_jets[3 * i] +
                     sign * roundings * std::numeric_limits<double>::epsilon() * size_of(machine.topology().coordinates[i].sense(), reach);
    if (machine.place(PM_JET, 1, moved.data(), jets.data()) != PM_OK) return {INFINITY, INFINITY};
    for (std::size_t i = 1; i < size; ++i) {
      out.first = std::max(out.first, std::abs(jets[3 * i + 1] - state.placement_jets[3 * i + 1]));
      out.second = std::max(out.second, std::abs(jets[3 * i + 2] - state.placement_jets[3 * i + 2]));
    }
  }
  return out;
}

}  // namespace

Deviation jets_against_differences(const Machine& machine, const State& state) {
  const double length = characteristic_length(machine);
  double speed = 0;  // of the coordinates, in sizes a second
  for (std::size_t i = 0; i < state.coordinates.size(); ++i) {
    const double unit = size_of(machine.topology().coordinates[i].sense(), length);
    speed = std::max({speed, std::abs(state.coordinates[i].rate) / unit, std::sqrt(std::abs(state.coordinates[i].acceleration) / unit)});
  }
  Deviation d;
  if (speed == 0) return d;

  // What the motion brings about: accelerations also from rates alone.
  double rate_scale = length * speed, acceleration_scale = length * speed * speed;
  for (std::size_t i = 1; i < machine.layout().size(); ++i) {
    rate_scale = std::max(rate_scale, std::abs(state.placement_jets[3 * i + 1]));
    acceleration_scale = std::max(acceleration_scale, std::abs(state.placement_jets[3 * i + 2]));
  }
  // The usual step; near the end of reach, where the geometry turns in a much smaller one, the step that is known best.
  constexpr double enough_of_rates = 1e-13, enough_of_accelerations = 1e-11;  // a tenth of the least that any claim asks for
  constexpr double share = 1.0 / 16;
  constexpr int most_steps = 12;
  Stencil stencil(machine, state);
  std::optional<Differences> best;
  Extended step = 1e-3L / speed;
  for (int k = 0; k < most_steps; ++k, step *= share) {
    std::optional<Differences> there = stencil.at(step);
    if (!there) continue;
    if (!best || there->acceleration_error < best->acceleration_error) best = std::move(there);
    if (best->acceleration_error <= enough_of_accelerations * acceleration_scale && best->rate_error <= enough_of_rates * rate_scale) break;
  }
  if (!best) {
    d.reachable = false;
    return d;
  }
  for (std::size_t i = 1; i < machine.layout().size(); ++i) {
    d.rate = std::max(d.rate, std::abs(static_cast<double>(best->rate[i] - static_cast<Extended>(state.placement_jets[3 * i + 1]))));
    d.acceleration = std::max(
        d.acceleration, std::abs(static_cast<double>(best->acceleration[i] - static_cast<Extended>(state.placement_jets[3 * i + 2]))));
  }
  const auto [rates, accelerations] = rounding_of_jets(machine, state, length);
  d.rate /= rate_scale;
  d.acceleration /= acceleration_scale;
  d.rate_error = (best->rate_error + rates) / rate_scale;
  d.acceleration_error = (best->acceleration_error + accelerations) / acceleration_scale;
  return d;
}

}  // namespace pmreport::mechanics
