// [drive] and [limits]: what the actuators and joints are to be sized for.
#pragma once

#include <core/mechanics/dynamics/drive.hpp>
#include <core/scenario/mechanism_part.hpp>
#include <optional>
#include <string>
#include <vector>

namespace pmreport::scenario {

std::vector<mechanics::DriveTrain> read_drives(const Entry* entry, const MechanismPart& mechanism, const Reader& reader);
// What to write so that an actuator has a motor: "add to [drive], or to [drive.q], lead = "5 mm"".
std::string how_to_give_motor(const Actuator& a);
mechanics::MotionLimits read_limits(const Entry* entry, const MechanismPart& mechanism, const Reader& reader);
// A quantity from `least` to `most` `unit`, SI; told when it is not.
std::optional<double> read_within(const Entry& entry, double least, double most, const std::string& unit, const std::string& hint,
                                  const Reader& reader);

}  // namespace pmreport::scenario
