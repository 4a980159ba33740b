// One writer a folder.
#pragma once

#include <reports/document/folder/file.hpp>
#include <reports/document/write.hpp>

#include <filesystem>

namespace pmreport::document {

// Holds `.NAME.lock` beside the folder NAME, and removes it at the end. The kernel frees the lock of a process that dies; the empty file
// that is left then locks nobody out. Throws OutputError when another process has it.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  std::filesystem::path path_;
  Descriptor file_;
};

}  // namespace pmreport::document
