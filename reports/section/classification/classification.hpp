// Section `classification`: the class of parallel-cross mechanisms.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

Result classification_section();

}  // namespace pmreport::section
