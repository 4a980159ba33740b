// Numbers that every room needs by the same names.
#pragma once

#include <limits>
#include <numbers>

namespace pmreport {

inline constexpr double pi = std::numbers::pi;
inline constexpr double deg = pi / 180;  // rad
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace pmreport
