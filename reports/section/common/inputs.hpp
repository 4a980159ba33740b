// What went into a run: every parameter of the mechanism, and what the scenario says of motion, load, drives, limits and elasticity.
#pragma once

#include <reports/document/input.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// Parameters first, in the mechanism's order; then the scenario's, in the order of its text.
std::vector<document::Input> inputs_of(const Analysis& a);

}  // namespace pmreport::section
