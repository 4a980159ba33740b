// A motion by forces: whether inverse dynamics finds them again.
#pragma once

#include <core/analysis/analysis.hpp>

namespace pmreport::analysis {

// Largest deviation of the forces that the scenario gives from those that the integrated motion takes, relative to the largest share of
// load, weights or inertia; NaN where no sample has forces. The scenario's motion must follow from forces.
double given_against_found(const Analysis& a);

}  // namespace pmreport::analysis
