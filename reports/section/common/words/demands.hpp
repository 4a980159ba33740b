// What every report demands of its motion, by the names that its checks have.
#pragma once

#include <string>
#include <vector>

namespace pmreport::section::demands {

inline constexpr const char* assembly = "the mechanism can be assembled";
inline constexpr const char* limits = "strokes and joint limits are kept";
inline constexpr const char* regularity = "no singular surface is met";
inline constexpr const char* visibility = "the samples show the motion";
inline constexpr const char* smoothness = "values and rates of the motion do not jump";

}  // namespace pmreport::section::demands

namespace pmreport::section {

// A demand that fails tells the first of what breaks it, and of how much more the sections tell: " And 3 more."; "": no more.
inline std::string number_of_others(const std::vector<std::string>& sentences) {
  return sentences.size() > 1 ? " And " + std::to_string(sentences.size() - 1) + " more." : "";
}
inline std::string first_and_number(const std::vector<std::string>& sentences) {
  return sentences.empty() ? "" : sentences.front() + number_of_others(sentences);
}

}  // namespace pmreport::section
