// Section `displacement`: pose, actuators and joints over the motion.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

const SectionKind& displacement_kind();
Result displacement_section(const Analysis& a);

}  // namespace pmreport::section
