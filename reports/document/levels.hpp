// How much of a report is shown: the same numbers and evidence, arranged for one who hurries, one who works with it, or one who wants all.
#pragma once

#include <reports/document/report.hpp>

namespace pmreport::document {

// brief: of each section its warnings, the first figure or picture, and its evidence. engineering: long tables stand in a section of their
// own at the end, and where they were a line says so, or their first rows where these are the worst. full: as it is. Values, checks,
// evidence and data files are the same in all.
enum class Detail { brief, engineering, full };

Report arranged(Report r, Detail detail);

}  // namespace pmreport::document
