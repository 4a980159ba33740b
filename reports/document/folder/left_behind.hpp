// What a run leaves behind if it is ended in its midst: told as it comes and as it goes, so that somebody else can clear it away.
#pragma once

#include <filesystem>

namespace pmreport::document {

enum class Left : char {
  folder = 'T',  // one that is being filled
  lock = 'K',
  parent = 'W'  // a folder made on the way to another, to go while it is empty
};

// Of this process: `there` is called with what was made, `gone` when it is gone or is to stay; `standing` when a report has been put in its
// place.
struct LeftBehindWatch {
  void (*there)(Left what, const std::filesystem::path&);
  void (*gone)(const std::filesystem::path&);
  void (*standing)(const std::filesystem::path& folder);
};
void watch_left_behind(const LeftBehindWatch& watch);

// For those who make such things.
void now_there(Left what, const std::filesystem::path& path);
void now_gone(const std::filesystem::path& path);
void now_standing(const std::filesystem::path& folder);

// Removes what another process has left. A lock that somebody else holds by now stays, and so does a parent that is not empty.
void clear_left_behind(Left what, const std::filesystem::path& path) noexcept;
// All that this process has made and not removed, where it is about to end in the midst.
void clear_all_left_behind() noexcept;

}  // namespace pmreport::document
