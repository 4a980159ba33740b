// The indices of transmission of a pose as a list of numbers: what columns, maps and grids share.
#pragma once

#include <core/mechanics/transmission/transmission.hpp>

#include <span>
#include <string>
#include <vector>

namespace pmreport::analysis {

// In the order of transmission_columns(topology): one number a column, NaN where the mechanism has none, and all of them where the pose
// cannot be assembled or has no G. Angles in [rad].
void transmission_numbers(const mechanics::Transmission& t, std::span<const double> coordinates, mechanics::Transmission::Work& work,
                          std::span<double> out);

// Why the mechanism never has a number of a column: "it acts on the platform by ..., at no one point"; empty where it has.
std::vector<std::string> why_without(const mechanics::Transmission& t);

constexpr double good_transmission = 0.7;  // from which a transmission is called good: 45.6 degrees of pressure angle

}  // namespace pmreport::analysis
