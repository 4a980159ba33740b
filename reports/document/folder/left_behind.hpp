// What a run leaves behind if it is ended in its midst: told as it comes and as it goes, so that somebody else can clear it away.
#pragma once

#include <filesystem>

namespace pmreport::document {

// Of this process: `left_behind` is called with what was made, a file that locks, a folder that is being filled or one on the way to it,
// and again when it is gone or is to stay; `standing` when a report has been put in its place.
void watch_left_behind(void (*left_behind)(const std::filesystem::path& path, bool there), void (*standing)(const std::filesystem::path&));

// For those who make such things.
void now_there(const std::filesystem::path& path);
void now_gone(const std::filesystem::path& path);
void now_standing(const std::filesystem::path& folder);

// Removes what another process has left. A lock that somebody else holds by now stays, and so does a folder made on the way that is not
// empty.
void clear_left_behind(const std::filesystem::path& path) noexcept;
// All that this process has made and not removed, where it is about to end in the midst.
void clear_all_left_behind() noexcept;

}  // namespace pmreport::document
