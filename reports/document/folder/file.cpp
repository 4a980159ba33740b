#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <reports/document/folder/file.hpp>
#include <reports/document/write.hpp>
#include <system_error>

namespace pmreport::document {

namespace {

const char* remedy(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "Free some space, or choose a folder on another disk.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "A report is made beside its place, then renamed: choose a place in a folder that you may write.";
    case ENOTDIR:
      return "A part of this path is a file; choose another folder.";
    case ENAMETOOLONG:
      return "Choose a shorter name.";
    case EBUSY:
    case EXDEV:
      return "The folder is a mount point or in use; name a folder inside it.";
    default:
      return "Choose another folder.";
  }
}

}  // namespace

Descriptor::~Descriptor() { close(); }

bool Descriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0 || errno == EINTR;  // Linux frees the number even then
}

void fail(const char* deed, const std::filesystem::path& path, int error) {
  throw OutputError("cannot " + std::string(deed) + " " + path.string() + ": " + std::generic_category().message(error) + ". " +
                    remedy(error));
}

void write_new_file(const std::filesystem::path& path, std::string_view bytes) {
  write_new_file(path, [&](const auto& put) { put(bytes); });
}

void write_new_file(const std::filesystem::path& path, const Pieces& pieces) {
  Descriptor file(open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (file.number() < 0) fail("make", path, errno);
  constexpr std::size_t most = 1u << 30;  // Linux writes at most 2 GiB a call
  pieces([&](std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file.number(), bytes.data(), std::min(bytes.size(), most));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail("write", path, written < 0 ? errno : ENOSPC);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  });
  if (fsync(file.number()) != 0) fail("write", path, errno);
  if (!file.close()) fail("write", path, errno);
}

void make_folder(const std::filesystem::path& path, mode_t mode) {
  if (mkdir(path.c_str(), mode) != 0) fail("make", path, errno);
}

bool make_missing_folder(const std::filesystem::path& path) {
  if (mkdir(path.c_str(), 0777) == 0) return true;
  const int error = errno;
  std::error_code none;
  if (error == EEXIST && std::filesystem::is_directory(path, none)) return false;
  fail("make", path, error);
}

void remove_tree(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto let_owner_in = [&](const fs::path& folder) { fs::permissions(folder, fs::perms::owner_all, fs::perm_options::add, ignored); };
  if (!fs::is_directory(fs::symlink_status(path, ignored))) return;
  let_owner_in(path);
  for (fs::directory_iterator at(path, ignored); !ignored && at != fs::directory_iterator(); at.increment(ignored))
    if (std::error_code none; fs::is_directory(at->symlink_status(none))) let_owner_in(at->path());
  fs::remove_all(path, ignored);
}

bool is_still_named(const Descriptor& file, const std::filesystem::path& path) {
  struct stat held {
  }, named{};
  return fstat(file.number(), &held) == 0 && lstat(path.c_str(), &named) == 0 && held.st_ino == named.st_ino && held.st_dev == named.st_dev;
}

void sync_folder(const std::filesystem::path& path) {
  const Descriptor folder(open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.number() < 0) fail("open", path, errno);
  if (fsync(folder.number()) != 0 && errno != EINVAL) fail("write", path, errno);  // EINVAL: this file system has nothing to sync
}

}  // namespace pmreport::document
