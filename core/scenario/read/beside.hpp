// Files that a scenario names.
#pragma once

#include <core/scenario/read/diagnostics.hpp>
#include <filesystem>
#include <optional>
#include <string>

namespace pmreport::scenario {

// A file of the scenario's own folder. Whoever sends a scenario around shall not read other files with it: no way up, no absolute path, no
// link out of the folder, and nothing but regular files, since a device or a pipe may never end. What is none is told at `place`.
std::optional<std::filesystem::path> file_beside(const std::string& given, Place place, const std::filesystem::path& scenario,
                                                 Diagnostics& diagnostics);
// As the user is shown it: beside the scenario as that was given.
std::string shown_beside(const std::string& given, const std::filesystem::path& scenario);

}  // namespace pmreport::scenario
