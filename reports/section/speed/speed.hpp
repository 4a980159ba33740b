// Section `speed`, and its parts.
#pragma once

#include <core/analysis/study/speed_study.hpp>
#include <reports/section/kind.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

Result speed_section(const Analysis& a);

// With four digits, rounded so that a motion of the speed, or the duration, that a reader takes from it keeps the limit.
std::string speed_words(double scale);       // down: "1.643"
std::string duration_words(double seconds);  // up: "1.218 s"

using analysis::SpeedStudy;

std::string subject(const Analysis& a, const mechanics::SpeedLimit& l);        // "torque of θ₁ (angle of arm 1)", "force in joint B1"
std::string brief_subject(const Analysis& a, const mechanics::SpeedLimit& l);  // "torque of θ₁", for a table
std::string unit_of(const Analysis& a, const mechanics::SpeedLimit& l);        // SI

figure::Figure phase_plane(const Analysis& a, const SpeedStudy& study);
figure::Figure at_scale(const Analysis& a, const SpeedStudy& study);  // what is limited, at the largest speed, against its limits
std::vector<document::Evidence> evidence(const SpeedStudy& study);

}  // namespace pmreport::section
