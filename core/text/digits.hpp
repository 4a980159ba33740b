// Numbers that are told beside each other, with the digits that set them apart.
#pragma once

#include <string>
#include <vector>

namespace pmreport {

// Each with `digits` significant digits where these show the difference between the smallest and the largest number to `of_span` digits;
// else all with as many decimals as that takes, and as a double has: "1200.06" and "1200.00", never "1200" twice. Numbers that are equal
// but for `rounding` are not set apart.
std::vector<std::string> format_together(const std::vector<double>& values, int digits, int of_span, double rounding = 0);

// A number that lies outside [low, high], with the digits that set it apart from the end beyond which it lies.
std::string format_outside(double seen, double low, double high, int digits);

}  // namespace pmreport
