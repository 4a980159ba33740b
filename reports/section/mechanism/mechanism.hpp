// Section `mechanism`: what it is, its parameters, joints, bodies and mobility.
#pragma once

#include <reports/section/common/stage.hpp>
#include <reports/section/kind.hpp>

namespace pmreport::section {

Result mechanism_section(const Analysis& a, const Stage& stage);

}  // namespace pmreport::section
