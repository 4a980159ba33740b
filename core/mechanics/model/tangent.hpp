// How bodies and actuators move together, to first order: a basis of the motions that the mechanism has at a pose.
//
// The rates of the independent coordinates are such a basis nearly everywhere, and the exact partials of `place` give its columns. But
// coordinates are a chart, and angles have poses where two of them turn the platform about one axis: there their rates reach one twist
// less than the machine does. The machine knows nothing of it. Where the columns of the platform, each of unit size, come to less than
// `poor_chart` of a full basis, the motions are taken from the constraints of the bodies instead,
//     PHI V = 0,   of which those that move the platform: V = N s,  N_P of full rank               (1)
// in s of the platform's twist. What is linear in the motion and asks for no coordinate (forces of the actuators, the inertia that they
// feel) comes out the same from either basis.
#pragma once

#include <core/mechanics/model/state.hpp>

#include <optional>
#include <string>
#include <vector>

namespace pmreport::mechanics {

struct Tangent {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  // as the contract has partials
  Rows bodies;                 // K, 6 n x m: (velocity of the origin; angular velocity) of the bodies 1..n, a column each motion
  SmallMatrix actuators;       // J, m x m: rates of the actuators
  bool by_coordinates = true;  // the motions are the unit rates of the coordinates
  std::vector<double> placement_partials;  // as the contract has them
};
// Of the pose of `state`, which is PM_OK. The second reuses the memory of `out`.
Tangent tangent(const Machine& machine, const State& state);
void tangent(const Machine& machine, const State& state, Tangent& out);

// Below it the columns lose more digits than the constraints of the bodies.
constexpr double poor_chart = 1e-4;

// Coordinates that turn the platform about nearly one axis, or move it along nearly one line.
struct ChartFault {
  double quality = 1;            // smallest singular value of the platform's columns, each of unit size: 0 where the chart is singular
  std::vector<int> coordinates;  // that take part
};
// At coordinates [m], [rad]: nothing where the quality is above `nearly_singular`, or the pose cannot be assembled. `length`:
// characteristic_length(machine) [m].
constexpr double nearly_singular = 0.02;
std::optional<ChartFault> chart_fault(const Machine& machine, const SmallVector& coordinates, double length);
// "alpha and gamma turn the platform about one axis there: these coordinates are singular, the machine is not"
std::string in_words(const Machine& machine, const ChartFault& fault);

}  // namespace pmreport::mechanics
