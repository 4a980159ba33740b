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

// The part of the work that comes in chunks, by a process that shares it with others and does not collect the answers: what is done is kept
// as `progress.sharing` says. Throws as making the report does.
void share_work(const scenario::Loaded& loaded, const Progress& progress);

}  // namespace pmreport::section
