// What can be known of a library without running a line of it. Loading runs its static constructors, and a truncated file ends the process
// with SIGBUS, so a file is looked at first.
#pragma once

#include <filesystem>

namespace pmreport::host {

// Throws PluginError unless `path` is a whole shared library for this program's machine that defines the data symbol `pm_plugin`.
void require_plugin_library(const std::filesystem::path& path);

}  // namespace pmreport::host
