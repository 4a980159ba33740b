// Proof of a motion by actuators: they move as the scenario prescribes.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// The actuators by inverse displacement of the coordinates found, and by the jets along them, against what is prescribed: values, rates,
// accelerations. None for a motion of coordinates.
std::vector<document::Evidence> prescribed_evidence(const Analysis& a);

}  // namespace pmreport::section
