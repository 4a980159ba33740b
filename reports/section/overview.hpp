// Every actuator at a glance.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// Small multiples, a row an actuator: stroke, speed, force and power, as far as the scenario asks for their sections; its worst point
// marked in each, and what limits it. None of fewer than three such columns.
std::vector<document::Section> overview_section(const Analysis& a);

}  // namespace pmreport::section
