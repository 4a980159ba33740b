// The handful of numbers that a hurried reader looks for: how near the machine comes to what limits it.
#pragma once

#include <reports/document/report.hpp>
#include <reports/section/common/analysis.hpp>

#include <vector>

namespace pmreport::section {

// At most six, of the sections that the report has: those beyond their limit first, then those that use most of it, then those that nothing
// limits. A number without a limit of its own takes that of a check that holds the same number against one.
std::vector<document::KeyNumber> key_numbers(const Analysis& a, const document::Report& r);

}  // namespace pmreport::section
