// What of a motion's forces is out of proportion, or worth a sentence: found from the columns, said with their numbers.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// "A load of 14 N asks 218 N of l₃ at t = 1.2 s, 16 times as much, where the condition number is 523."; what asks for the largest force;
// another assembly that is near. `r`: with its values and sections.
std::vector<document::Finding> surprises(const Analysis& a, const document::Report& r);

}  // namespace pmreport::section
