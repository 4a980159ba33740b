// From a scenario and its machine to the report.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// The whole report. `build` is the plugin's, `version` the program's.
document::Report make_report(const scenario::Scenario& s, const mechanics::Machine& m, const std::string& version, const std::string& build,
                             const Progress& progress);

}  // namespace pmreport::section
