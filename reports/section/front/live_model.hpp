// The machine as the page moves it: its geometry as JavaScript, what bounds it, what it carries.
#pragma once

#include <reports/section/common/analysis.hpp>

#include <string>

namespace pmreport::section {

// An object of JavaScript, which live.js makes live; empty where the mechanism records no program, or another geometry than its own. SI
// units, each with the unit that a reader expects and the factor to it.
std::string live_model(const Analysis& a);

}  // namespace pmreport::section
