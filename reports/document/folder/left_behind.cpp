#include <reports/document/folder/file.hpp>
#include <reports/document/folder/left_behind.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace pmreport::document {

namespace {

namespace fs = std::filesystem;

// Never destroyed: it is asked at the very end.
struct Known {
  std::timed_mutex guard;
  std::vector<std::pair<Left, fs::path>> all;
  std::optional<LeftBehindWatch> watch;
};
Known& known() {
  static Known& one = *new Known;
  return one;
}

// Only where nobody holds it, or this process does: one that took it over since then goes on holding the file that has the name.
void remove_lock(const fs::path& path, bool own) {
  const Descriptor file(open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
  if (file.number() < 0 || (!own && flock(file.number(), LOCK_EX | LOCK_NB) != 0)) return;
  if (is_still_named(file, path)) unlink(path.c_str());
}

void clear(Left what, const fs::path& path, bool own) {
  switch (what) {
    case Left::folder:
      remove_tree(path);
      break;
    case Left::lock:
      remove_lock(path, own);
      break;
    case Left::parent:
      rmdir(path.c_str());
      break;
  }
}

}  // namespace

void watch_left_behind(const LeftBehindWatch& watch) {
  const std::lock_guard lock(known().guard);
  known().watch = watch;
}

void now_there(Left what, const fs::path& path) {
  const std::lock_guard lock(known().guard);
  known().all.emplace_back(what, path);
  if (known().watch) known().watch->there(what, path);
}

void now_gone(const fs::path& path) {
  const std::lock_guard lock(known().guard);
  std::erase_if(known().all, [&](const auto& one) { return one.second == path; });
  if (known().watch) known().watch->gone(path);
}

void now_standing(const fs::path& folder) {
  const std::lock_guard lock(known().guard);
  if (known().watch) known().watch->standing(folder);
}

void clear_left_behind(Left what, const fs::path& path) noexcept try { clear(what, path, false); } catch (...) {
}

// Who hangs with the list in hand keeps it: then all stays for the next run to clear.
void clear_all_left_behind() noexcept try {
  const std::unique_lock lock(known().guard, std::chrono::seconds(1));
  if (!lock) return;
  for (auto one = known().all.rbegin(); one != known().all.rend(); ++one) clear(one->first, one->second, true);
} catch (...) {
}

}  // namespace pmreport::document
