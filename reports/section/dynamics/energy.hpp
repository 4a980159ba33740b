// Section `dynamics`: that power and work become energy, shown, or why it is not.
#pragma once

#include <core/analysis/study/motion_work.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <optional>
#include <vector>

namespace pmreport::section {

struct EnergyEvidence {
  std::vector<document::Evidence> lines;
  std::vector<document::Paragraph> notes;  // what is not decided, or not examined, and why
};
// Of the work along a motion that is prescribed; of power at its samples, where some could be compared.
EnergyEvidence energy_evidence(const Analysis& a, const std::optional<analysis::MotionWork>& work);

}  // namespace pmreport::section
