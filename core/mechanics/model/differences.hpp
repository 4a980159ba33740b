// Rates and accelerations of a placement by differences in extended precision: a judge of the jets that shares nothing with them but
// `place`.
#pragma once

#include <core/mechanics/model/state.hpp>

namespace pmreport::mechanics {

// Largest deviation of the jets of a state from central differences of eighth order of `place` along q(t + s) = q + q' s + q'' s^2 / 2,
// which has the same value, rate and acceleration at s = 0. In numbers of the mechanism's own size: lengths by its characteristic length,
// rates by the largest rate of the placement, likewise accelerations. The step moves the coordinates by a thousandth of that size, so the
// truncation is about 1e-24 and, with 64 bits of mantissa, the rounding 1e-16 for rates and 1e-13 for accelerations.
//
// Near the end of reach neither side has as many digits. What is known of them there is measured, not assumed: how far the differences of
// eighth order are from those of sixth order over the same points, at the step that brings them nearest, bounds their error; how much the
// jets change with the coordinates moved by a few roundings of the mechanism's size bounds that of the jets.
struct Deviation {
  double rate = 0, acceleration = 0;
  double rate_error = 0, acceleration_error = 0;  // how far the two sides are known themselves, relative likewise
  bool reachable = true;  // false: a point of the stencil cannot be assembled (the pose is at the edge of reach); nothing was compared
};
Deviation jets_against_differences(const Machine& machine, const State& state);

}  // namespace pmreport::mechanics
