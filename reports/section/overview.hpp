// The motion at a glance.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// Pose, limb lengths, rates, accelerations and forces on one page, when the scenario asks for enough of them.
std::vector<document::Section> overview_section(const Analysis& a);

}  // namespace pmreport::section
