// A comparison as a page.
#pragma once

#include <reports/compare/comparison.hpp>

#include <string>

namespace pmreport::compare {

// One file, no network, no script; readable at phone width. `version`: of this program.
std::string to_html(const Comparison& c, const std::string& version);

}  // namespace pmreport::compare
