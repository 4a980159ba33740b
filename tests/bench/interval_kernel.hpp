// Six legs of a hexapod over a box of positions, the platform not turned: of each its length squared, which is to stay in its stroke, and
// how far it leans from the axis of its joint, which is to stay in a cone. What every type of numbers is measured on.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace pmreport::bench {

struct PositionBox {
  double middle[3], half;  // [m]
};

struct Hexapod {
  struct Leg {
    double from_base[3];  // from the joint at the base to that on the platform, at the origin [m]
    double axis[3];
  };
  std::array<Leg, 6> legs;
  double cosine = std::cos(std::numbers::pi / 6);  // of the cone

  Hexapod() {
    const double at_base[6] = {15, 105, 135, 225, 255, 345}, on_platform[6] = {45, 75, 165, 195, 285, 315};
    for (std::size_t i = 0; i < 6; ++i) {
      const double a = at_base[i] * std::numbers::pi / 180, b = on_platform[i] * std::numbers::pi / 180;
      const double home[3] = {0.2 * std::cos(b) - 0.3 * std::cos(a), 0.2 * std::sin(b) - 0.3 * std::sin(a), 0.8};
      const double length = std::hypot(home[0], home[1], home[2]);
      for (std::size_t c = 0; c < 3; ++c) legs[i].axis[c] = home[c] / length;
      legs[i].from_base[0] = home[0];
      legs[i].from_base[1] = home[1];
      legs[i].from_base[2] = 0;
    }
  }
};

// A number that all margins have a part in.
template <class T>
T margins(const Hexapod& hexapod, const std::array<T, 3>& p) {
  T sum(0.0);
  for (const Hexapod::Leg& leg : hexapod.legs) {
    const T d0 = p[0] + leg.from_base[0], d1 = p[1] + leg.from_base[1], d2 = p[2] + leg.from_base[2];
    const T squared = square(d0) + square(d1) + square(d2);
    const T lean = d0 * leg.axis[0] + d1 * leg.axis[1] + d2 * leg.axis[2] - sqrt(squared) * hexapod.cosine;
    sum = sum + (lean + squared);
  }
  return sum;
}

// Those who compute it for all boxes: the sum of the low ends.
using Contender = double (*)(const Hexapod&, std::span<const PositionBox>);
double in_plain_numbers(const Hexapod&, std::span<const PositionBox>);  // of the middles alone
double in_plain_lanes(const Hexapod&, std::span<const PositionBox>);
double in_intervals(const Hexapod&, std::span<const PositionBox>);
double in_interval_lanes(const Hexapod&, std::span<const PositionBox>);
double in_widened(const Hexapod&, std::span<const PositionBox>);  // rounding to nearest, each end moved by a neighbour
double in_widened_lanes(const Hexapod&, std::span<const PositionBox>);
double by_arb(const Hexapod&, std::span<const PositionBox>);
double by_mpfi(const Hexapod&, std::span<const PositionBox>);
double by_boost(const Hexapod&, std::span<const PositionBox>);
double by_boost_saving_the_mode(const Hexapod&, std::span<const PositionBox>);

}  // namespace pmreport::bench
