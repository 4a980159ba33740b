// Small reports to hold against each other.
#pragma once

#include <reports/compare/comparison.hpp>
#include <reports/document/report.hpp>

#include <string>
#include <vector>

namespace compare_test {

// Two values, a check, two lines of evidence, a curve of three samples.
inline pmreport::document::Report report() {
  using namespace pmreport::document;
  Report r;
  r.title = "Sample";
  r.provenance = {"pmreport", "1.0.0", "gough", "C++", "motion.toml", "0a"};
  r.values = {{"displacement", "max(x)", "m", 0.5}, {"statics", "max(l1_force)", "N", 1024.0}};
  Check check;
  check.name = "max(abs(actuator_force)) < 400 N";
  check.value = 312;
  check.unit = "N";
  check.passed = true;
  r.checks = {check};
  Section section{"displacement", "displacement", "Displacement", {}};
  section.blocks.push_back(Proof{{{"every joint meets", "two ways", 1e-12, 1e-9, "m"}, {"strokes are kept", "samples", 0, 0, ""}}});
  r.sections = {section};
  r.data = {{"displacement", {"t [s]", "x [m]"}, {{0, 1, 2}, {0, 0.5, 0}}}};
  return r;
}

inline std::vector<pmreport::compare::Results> results(const std::vector<pmreport::document::Report>& reports) {
  std::vector<pmreport::compare::Results> out;
  for (const auto& r : reports) out.push_back(pmreport::compare::results_of(r, "report " + std::to_string(out.size() + 1)));
  return out;
}

}  // namespace compare_test
