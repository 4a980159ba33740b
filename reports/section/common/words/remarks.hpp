// What of a mechanism's data looks odd, as a report tells it.
#pragma once

#include <reports/section/common/analysis.hpp>

#include <string>
#include <vector>

namespace pmreport::section {

// A sentence each, of core/mechanics/conformance/plausibility.hpp.
std::vector<std::string> remark_sentences(const mechanics::Machine& machine);

// The same for a report's summary: none where neither inertia nor weight enters any number of it.
std::vector<std::string> remark_sentences(const Analysis& a);

}  // namespace pmreport::section
