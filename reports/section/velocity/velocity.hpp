// Section `velocity`: rates, the twist of the platform, and how well the overall Jacobian is conditioned.
#pragma once

#include <reports/section/kind.hpp>

namespace pmreport::section {

const SectionKind& velocity_kind();
Result velocity_section(const Analysis& a);

}  // namespace pmreport::section
