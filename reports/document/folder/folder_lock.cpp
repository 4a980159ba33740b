#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <reports/document/folder/folder_lock.hpp>
#include <reports/document/folder/left_behind.hpp>
#include <reports/document/write.hpp>

namespace pmreport::document {

FolderLock::FolderLock(const std::filesystem::path& folder) : path_(folder.parent_path() / ("." + folder.filename().string() + ".lock")) {
  do {
    file_ = Descriptor(open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (file_.number() < 0) fail("make", path_, errno);
    int status = 0;
    do status = flock(file_.number(), LOCK_EX | LOCK_NB);
    while (status != 0 && errno == EINTR);
    if (status != 0 && errno == EWOULDBLOCK) {
      throw OutputError("cannot write the report " + folder.string() +
                        ": another run is writing it now. Wait until that has ended, or choose another folder.");
    }
    if (status != 0) fail("lock", path_, errno);
  } while (!is_still_named(file_, path_));
  now_there(Left::lock, path_);
}

// Removed while still locked: a waiting process then sees that its file has lost its name, and starts anew.
FolderLock::~FolderLock() {
  unlink(path_.c_str());
  now_gone(path_);
}

}  // namespace pmreport::document
