// Is what a plugin exports fit for use? Judged from its constants alone: no function of the plugin is called.
#pragma once

#include <pmreport/plugin.h>

#include <string>

namespace pmreport::host {

// Throws PluginError, its sentence beginning with `where`: another ABI, a struct that is too short, a null pointer, a name or a parameter
// that makes no sense.
void require_sound(const pm_plugin_table& table, const std::string& where);

}  // namespace pmreport::host
