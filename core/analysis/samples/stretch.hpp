// Stretches of a motion between its knots: what is differentiated or integrated along it never straddles one.
#pragma once

#include <core/mechanics/trajectory/trajectory.hpp>
#include <core/scenario/load.hpp>

#include <vector>

namespace pmreport::analysis {

// Of the motion and of its load, rising.
std::vector<double> knots_along(const mechanics::Trajectory& trajectory, const scenario::Load& load);

struct Stretch {
  double begin, end;
};
// From the knot before t, or at t, to the one after it; from `begin` and to `end` where there is none.
Stretch stretch_at(const std::vector<double>& knots, double t, double begin, double end);

}  // namespace pmreport::analysis
