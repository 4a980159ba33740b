// Section `acceleration`: accelerations of actuators and platform.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

const SectionKind& acceleration_kind();
Result acceleration_section(const Analysis& a);

}  // namespace pmreport::section
