// Where a motion meets a singular surface: between samples, by bisection in time.
#pragma once

#include <core/mechanics/mobility/mobility_count.hpp>
#include <core/mechanics/trajectory/trajectory.hpp>

#include <Eigen/Core>
#include <vector>

namespace pmreport::analysis {

// The motion meets a singular surface: det G changes its sign, or touches zero, at `time`.
struct Crossing {
  int before;                   // sample at or before it
  double time;                  // [s], to the last digits of a double
  Eigen::VectorXd coordinates;  // there
  bool touches = false;         // it comes back on the same side
  bool pole = false;            // det G passes through infinity, not zero: a limb is singular
};

// `determinant`: det G at every sample. `mobility`: of the machine at home; `length`: its characteristic length [m].
std::vector<Crossing> find_crossings(const mechanics::Trajectory& trajectory, const mechanics::Machine& machine,
                                     const std::vector<double>& determinant, const mechanics::Mobility& mobility, double length);

}  // namespace pmreport::analysis
