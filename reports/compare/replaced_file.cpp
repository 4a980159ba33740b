#include <reports/compare/replaced_file.hpp>

#include <reports/document/folder/file.hpp>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace pmreport::compare {

namespace fs = std::filesystem;

namespace {

// Gone at the end, unless it has been renamed.
class PartialFile {
 public:
  explicit PartialFile(fs::path path) : path_(std::move(path)) { unlink(path_.c_str()); }  // what a killed process of this number has left
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile() {
    if (!renamed_) unlink(path_.c_str());
  }
  const fs::path& path() const { return path_; }
  void rename_to(const fs::path& file) {
    if (std::rename(path_.c_str(), file.c_str()) != 0) document::fail("replace", file, errno);
    renamed_ = true;
  }

 private:
  fs::path path_;
  bool renamed_ = false;
};

}  // namespace

void replace_file(const fs::path& file, std::string_view bytes) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(file, error), error);
  if (error) document::fail("reach", file, error.value());
  const fs::file_status status = fs::symlink_status(target, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw document::OutputError("cannot replace " + file.string() + ": expected a file or nothing there. Choose another name.");
  PartialFile partial(target.parent_path() / ("." + target.filename().string() + "." + std::to_string(getpid()) + ".partial"));
  document::write_new_file(partial.path(), bytes);
  partial.rename_to(target);
  document::sync_folder(target.parent_path());
}

}  // namespace pmreport::compare
