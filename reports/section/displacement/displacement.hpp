// Section `displacement`: pose, actuators and joints over the motion.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

Result displacement_section(const Analysis& a);

}  // namespace pmreport::section
