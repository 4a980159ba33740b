#include <reports/section/displacement/prescribed.hpp>

#include <core/analysis/study/prescribed.hpp>

namespace pmreport::section {

std::vector<document::Evidence> prescribed_evidence(const Analysis& a) {
  if (!a.scenario().motion->by_actuators()) return {};
  const analysis::PrescribedDeviation d = analysis::prescribed_deviation(a);
  return {{"The actuators have the prescribed values", "inverse displacement of the pose found, relative to the mechanism's size", d.value,
           1e-11, ""},
          {"The actuators have the prescribed rates", "by differentiation along the rates found, relative to the largest rate", d.rate,
           1e-9, ""},
          {"The actuators have the prescribed accelerations",
           "by differentiation along the accelerations found, relative to the largest acceleration", d.acceleration, 1e-9, ""}};
}

}  // namespace pmreport::section
