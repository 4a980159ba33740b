// The plugin's recording of its geometry, taken over the contract.
#pragma once

#include <pmreport/plugin.h>
#include <core/program/program.hpp>

namespace pmreport::mechanics {

// Inputs: dof coordinates; outputs: `outputs` numbers, as of pm_recording. Throws program::ProgramError: the plugin records nothing, which
// those before contract 1.3 do not, or nothing that can be used; the sentence says why there is no program.
program::Program record_geometry(const pm_mechanism& table, const pm_instance* instance, int dof, std::size_t outputs);

}  // namespace pmreport::mechanics
