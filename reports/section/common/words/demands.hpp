// What every report demands of its motion, by the names that its checks have.
#pragma once

namespace pmreport::section::demands {

inline constexpr const char* assembly = "the mechanism can be assembled";
inline constexpr const char* limits = "strokes and joint limits are kept";
inline constexpr const char* regularity = "no singular surface is met";
inline constexpr const char* visibility = "the samples show the motion";
inline constexpr const char* smoothness = "values and rates of the motion do not jump";

}  // namespace pmreport::section::demands
