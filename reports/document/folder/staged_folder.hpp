// A folder that is replaced as a whole or not at all.
#pragma once

#include <reports/document/folder/file.hpp>
#include <reports/document/folder/folder_lock.hpp>
#include <reports/document/write.hpp>

#include <sys/types.h>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace pmreport::document {

// Parents of the folder that had to be made; gone again unless kept.
class MadeParents {
 public:
  explicit MadeParents(const std::filesystem::path& folder);
  MadeParents(const MadeParents&) = delete;
  MadeParents& operator=(const MadeParents&) = delete;
  ~MadeParents();
  void keep();

 private:
  void take_back();
  std::vector<std::filesystem::path> made_;
};

// A folder and all in it, gone at the end.
class TemporaryFolder {
 public:
  TemporaryFolder(std::filesystem::path path, mode_t mode);
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Files are gathered in `.NAME.PID.partial` beside the folder NAME; `commit` puts it in NAME's place in one step of the file system.
// Whatever fails throws OutputError and leaves NAME as it was, nothing beside it. Only an empty folder or an earlier report is ever
// replaced, and only one process at a time may do so.
class StagedFolder {
 public:
  explicit StagedFolder(const std::string& folder);
  void add(const std::string& name, std::string_view bytes);  // "figures/displacement.svg": at most one folder deep
  void add(const std::string& name, const Pieces& pieces);
  void commit();

 private:
  std::filesystem::path target_;
  MadeParents parents_;
  FolderLock lock_;
  TemporaryFolder partial_;
};

// Exchanges two folders of one parent in one step where the file system can, else in two renames with the first undone when the second
// fails. `old` need not exist. False: not possible, errno says why.
bool put_in_place(const std::filesystem::path& fresh, const std::filesystem::path& old);
bool put_in_place_by_two_renames(const std::filesystem::path& fresh, const std::filesystem::path& old);

}  // namespace pmreport::document
