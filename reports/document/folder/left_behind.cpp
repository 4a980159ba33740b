#include <reports/document/folder/file.hpp>
#include <reports/document/folder/left_behind.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

namespace pmreport::document {

namespace {

namespace fs = std::filesystem;

void (*on_left_behind)(const fs::path&, bool) = nullptr;
void (*on_standing)(const fs::path&) = nullptr;

// Never destroyed: it is asked at the very end.
struct Known {
  std::mutex guard;
  std::vector<fs::path> paths;
};
Known& known() {
  static Known& one = *new Known;
  return one;
}

bool has_name_of(const fs::path& path, const char* ending) {
  const std::string name = path.filename().string();
  return name.starts_with('.') && name.ends_with(ending);
}

// Only where nobody holds it, or this process does: one that took it over since then goes on holding the file that has the name.
void remove_lock(const fs::path& path, bool own) {
  const Descriptor file(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
  if (own || (file.number() >= 0 && flock(file.number(), LOCK_EX | LOCK_NB) == 0)) unlink(path.c_str());
}

void clear(const fs::path& path, bool own) {
  std::error_code ignored;
  if (has_name_of(path, ".partial"))
    fs::remove_all(path, ignored);
  else if (has_name_of(path, ".lock"))
    remove_lock(path, own);
  else
    rmdir(path.c_str());
}

}  // namespace

void watch_left_behind(void (*left_behind)(const fs::path& path, bool there), void (*standing)(const fs::path&)) {
  on_left_behind = left_behind, on_standing = standing;
}

void now_there(const fs::path& path) {
  const std::lock_guard lock(known().guard);
  known().paths.push_back(path);
  if (on_left_behind != nullptr) on_left_behind(path, true);
}

void now_gone(const fs::path& path) {
  const std::lock_guard lock(known().guard);
  std::erase(known().paths, path);
  if (on_left_behind != nullptr) on_left_behind(path, false);
}

void now_standing(const fs::path& folder) {
  if (on_standing != nullptr) on_standing(folder);
}

void clear_left_behind(const fs::path& path) noexcept try { clear(path, false); } catch (...) {
}

void clear_all_left_behind() noexcept try {
  std::vector<fs::path> paths;
  {
    const std::unique_lock lock(known().guard, std::try_to_lock);  // who holds it may hang
    paths = known().paths;
  }
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) clear(*path, true);
} catch (...) {
}

}  // namespace pmreport::document
