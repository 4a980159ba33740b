// Other people's programs that read a PDF, as oracles.
#pragma once

#include <optional>
#include <string>

namespace sample {

// What `command` says on both its outputs, with {} in it replaced by a file that holds `pdf`; nothing, and a warning of the test, when its
// program is not installed.
std::optional<std::string> ask(const std::string& command, const std::string& pdf);

// The value in a line "Pages:    12" of pdfinfo.
std::string field(const std::string& info, const std::string& name);

}  // namespace sample
