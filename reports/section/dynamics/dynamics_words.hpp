// What the section `dynamics` says besides its figures: what was computed, which bodies have mass, the equations of motion.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

std::vector<document::Paragraph> dynamics_words(const Analysis& a);

// "platform 8 kg; 5 × cylinder 4 kg": the bodies in motion by mass, alike ones together.
std::string masses(const Topology& t);

// M q'' + c + g = J^T F + K^T w in the independent coordinates at these times, as tables; and what each actuator feels of M.
std::vector<document::Block> equations_of_motion(const Analysis& a, const std::vector<double>& times);

}  // namespace pmreport::section
