// What the motion asks of actuators and joints, against [limits] of the scenario.
#pragma once

#include <core/analysis/study/limits.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

using analysis::count_limits;
using analysis::limit_breaches;
using analysis::LimitCount;
using analysis::met_exactly;

// "t = 0.3 s to 0.42 s: torque of theta1 (arm 1) is 31.2 N·m, the limit is 25 N·m (worst at t = 0.36 s, 14 samples)."
std::string limit_sentence(const Analysis& a, const LimitBreach& b);
std::vector<std::string> limit_sentences(const Analysis& a);

}  // namespace pmreport::section
