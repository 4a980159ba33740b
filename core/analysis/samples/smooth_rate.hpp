// The rate of a quantity along a motion, by differences: for evidence that owes nothing to the derivatives it judges.
#pragma once

#include <functional>
#include <optional>

namespace pmreport::analysis {

struct SmoothRate {
  double value;
  double change;  // of it when the step was made smaller once more: what it is good to
};
// Of f at t, by eighth-order central differences within [begin, end]. Of smaller and smaller steps the one counts whose result changes
// least by the last. Where even that change is large, f is not smooth around t. Nothing at the ends, or where f is NaN around t.
// Where f is known not to be smooth, [begin, end] ends there.
std::optional<SmoothRate> smooth_rate(const std::function<double(double)>& f, double t, double begin, double end);

}  // namespace pmreport::analysis
