#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <reports/document/data/results.hpp>
#include <reports/document/folder/left_behind.hpp>
#include <reports/document/folder/staged_folder.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw OutputError("cannot write the report " + folder.string() + ": " + why);
}

// Where the folder really is, so that its parent is the one in which it can be renamed: a link stays, and what it points at is replaced.
fs::path resolve(const std::string& folder) {
  if (folder.empty() || folder.find('\0') != std::string::npos) throw OutputError("the report needs the name of a folder");
  std::error_code error;
  fs::path path = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) fail("reach", folder, error.value());
  if (!path.has_filename()) path = path.parent_path();
  if (fs::is_symlink(fs::symlink_status(path, error))) refuse(path, "it is a link to nothing. Choose another folder.");
  if (!path.has_relative_path()) refuse(path, "it is the root of the file system. Choose a folder inside it.");
  if (path == fs::current_path(error)) refuse(path, "it is the current folder, which cannot be replaced. Name a folder inside it.");
  return path;
}

std::string bytes_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return {};  // a pipe would keep whoever opens it waiting
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Replacing a folder deletes what was in it: nothing may be in it but the files that an earlier report says are its own.
void refuse_foreign(const fs::path& folder) {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(folder, error);
  if (status.type() == fs::file_type::not_found) return;
  if (error) fail("look at", folder, error.value());
  if (!fs::is_directory(status)) refuse(folder, "it is a file. Choose the name of a folder.");
  const auto ours = files_listed_in(bytes_of(folder / "results.json"));
  fs::recursive_directory_iterator at(folder, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (at->is_directory() && !at->is_symlink()) continue;
    const std::string name = at->path().lexically_relative(folder).generic_string();
    if (!ours) refuse(folder, "it holds " + name + ", and is no earlier report. Choose another folder, or empty this one.");
    if (std::ranges::find(*ours, name) == ours->end()) {
      refuse(folder, "it holds " + name + " beside an earlier report. Move that away, or choose another folder.");
    }
  }
  if (error) fail("read", folder, error.value());
}

fs::path partial_name(const fs::path& target, const std::string& process) {
  return target.parent_path() / ("." + target.filename().string() + "." + process + ".partial");
}

// Names that runs have left beside their target: ".NAME.PROCESS" and the ending.
std::vector<fs::path> left_beside(const fs::path& target, std::string_view ending) {
  const std::string head = "." + target.filename().string() + ".";
  std::vector<fs::path> out;
  std::error_code error;
  for (fs::directory_iterator at(target.parent_path(), error); !error && at != fs::directory_iterator(); at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.size() <= head.size() + ending.size() || !name.starts_with(head) || !name.ends_with(ending)) continue;
    const std::string process = name.substr(head.size(), name.size() - head.size() - ending.size());
    if (process.find_first_not_of("0123456789") == std::string::npos) out.push_back(at->path());
  }
  return out;
}

constexpr std::string_view filled = ".partial", set_aside = ".partial.old";

// What a killed run has left. Who holds the lock is the only one at work, so every other is dead, whatever its number says by now.
void remove_stale(const fs::path& target) {
  for (const std::string_view ending : {filled, set_aside})
    for (const fs::path& path : left_beside(target, ending)) remove_tree(path);
}

// A run that was killed between the two renames of put_in_place_by_two_renames has left no report in place: the one that was there returns.
// The new one then still stands beside it under its first name. Where it does not, the old report was replaced, and who removed the new one
// wants neither.
void restore(const fs::path& target) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(target, error))) return;
  for (const fs::path& old : left_beside(target, set_aside)) {
    const fs::path fresh = old.parent_path() / old.stem();
    if (!fs::exists(fs::symlink_status(fresh, error))) continue;
    if (rename(old.c_str(), target.c_str()) != 0) fail("restore", target, errno);
    return;
  }
}

// Who may look into a report is for its owner to say, and stays so. Where nothing stands yet, the process's mask says it.
mode_t mode_of(const fs::path& folder) {
  struct stat old {};
  return stat(folder.c_str(), &old) == 0 ? (old.st_mode & 07777) | S_IRWXU : 0777;
}

fs::path cleared(const fs::path& target) {
  restore(target);
  refuse_foreign(target);
  remove_stale(target);
  return partial_name(target, std::to_string(getpid()));
}

}  // namespace

MadeParents::MadeParents(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path path = folder.parent_path(); !fs::exists(path, error) && !error; path = path.parent_path()) missing.push_back(path);
  if (error) fail("reach", folder, error.value());
  try {
    for (auto path = missing.rbegin(); path != missing.rend(); ++path) {
      if (!make_missing_folder(*path)) continue;
      made_.push_back(*path);
      now_there(Left::parent, *path);
    }
  } catch (...) {
    take_back();
    throw;
  }
}

MadeParents::~MadeParents() { take_back(); }

void MadeParents::take_back() {
  for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
    rmdir(path->c_str());  // not if somebody else uses it by now
    now_gone(*path);
  }
}

void MadeParents::keep() {
  for (const fs::path& path : made_) now_gone(path);
  made_.clear();
}

TemporaryFolder::TemporaryFolder(fs::path path, mode_t mode) : path_(std::move(path)) {
  make_folder(path_, mode);
  now_there(Left::folder, path_);
}

TemporaryFolder::~TemporaryFolder() {
  remove_tree(path_);
  now_gone(path_);
}

StagedFolder::StagedFolder(const std::string& folder)
    : target_(resolve(folder)), parents_(target_), lock_(target_), partial_(cleared(target_), mode_of(target_)) {}

void StagedFolder::add(const std::string& name, std::string_view bytes) {
  add(name, [&](const auto& put) { put(bytes); });
}

void StagedFolder::add(const std::string& name, const Pieces& pieces) {
  const fs::path path = partial_.path() / name;
  std::error_code error;
  if (!fs::exists(path.parent_path(), error)) make_folder(path.parent_path());
  write_new_file(path, pieces);
}

void StagedFolder::commit() {
  for (const fs::directory_entry& entry : fs::directory_iterator(partial_.path())) {
    if (entry.is_directory()) sync_folder(entry.path());
  }
  sync_folder(partial_.path());
  refuse_foreign(target_);  // again: somebody may have saved a note there while the report was drawn
  // What the mask has taken away is given back, where a sandbox allows it.
  if (std::error_code error; fs::exists(target_, error)) chmod(partial_.path().c_str(), mode_of(target_));
  if (!put_in_place(partial_.path(), target_)) fail("replace", target_, errno);
  parents_.keep();
  now_standing(target_);
  // From here on the new report stands; that its name may not outlast a power cut is no failure to undo it for.
  if (const Descriptor parent(open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)); parent.number() >= 0)
    fsync(parent.number());
}

bool put_in_place(const fs::path& fresh, const fs::path& old) {
  if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0) return true;
  if (errno == ENOENT) return rename(fresh.c_str(), old.c_str()) == 0;
  if (errno != ENOSYS && errno != EINVAL && errno != ENOTSUP) return false;
  return put_in_place_by_two_renames(fresh, old);
}

bool put_in_place_by_two_renames(const fs::path& fresh, const fs::path& old) {
  const fs::path away = fresh.string() + ".old";
  const bool existed = rename(old.c_str(), away.c_str()) == 0;
  if (!existed && errno != ENOENT) return false;
  if (rename(fresh.c_str(), old.c_str()) != 0) {
    const int error = errno;
    if (existed) rename(away.c_str(), old.c_str());
    errno = error;
    return false;
  }
  remove_tree(away);
  return true;
}

}  // namespace pmreport::document
