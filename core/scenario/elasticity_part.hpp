// [elasticity] and [[element]]: what gives way, beside what the mechanism declares.
#pragma once

#include <core/scenario/mechanism_part.hpp>

#include <vector>

namespace pmreport::scenario {

// `drives`: by actuator, as [drive] has them. Gives the settings to the mechanism's machine, and its topology the elements that result.
void read_elasticity(const Entry* elasticity, const Entry* elements, const std::vector<mechanics::DriveTrain>& drives,
                     MechanismPart& mechanism, const Reader& reader);

}  // namespace pmreport::scenario
