// From a scenario and its machine to the report.
#pragma once

#include <core/scenario/loaded.hpp>
#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// The whole report. `build` is the plugin's, `version` the program's.
document::Report make_report(const scenario::Loaded& loaded, const std::string& version, const std::string& build,
                             const Progress& progress);

}  // namespace pmreport::section
