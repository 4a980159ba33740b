// One file that is replaced as a whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace pmreport::compare {

// Written and on the disk as `.NAME.PID.partial` beside `file`, then renamed. A link stays, and what it points at is replaced. Throws
// document::OutputError; `file` is as it was then, and nothing beside it.
void replace_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace pmreport::compare
