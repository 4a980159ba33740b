// What results.json says of itself: how a folder is known as a report of ours.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace pmreport::document {

inline constexpr const char* results_schema = "pmreport-results";

// The files that a report's results.json lists; nothing when the text is not such a file.
std::optional<std::vector<std::string>> files_listed_in(const std::string& results);

}  // namespace pmreport::document
