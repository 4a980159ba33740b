// Section `statics`: what holds the platform against its load at rest.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

const SectionKind& statics_kind();
Result statics_section(const Analysis& a);

}  // namespace pmreport::section
