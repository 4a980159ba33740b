// Files written so that every failure is seen, and told with what to do.
#pragma once

#include <filesystem>
#include <functional>
#include <reports/document/write.hpp>
#include <string_view>
#include <utility>

namespace pmreport::document {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int number() const { return number_; }
  bool close();  // false: the file system refused late, as a network one may

 private:
  int number_;
};

// Throws OutputError: "cannot DEED PATH: No space left on device. Free some space, ..."
[[noreturn]] void fail(const char* deed, const std::filesystem::path& path, int error);

// On the disk when it returns.
void write_new_file(const std::filesystem::path& path, std::string_view bytes);
// Of what `pieces` hands to its argument, one after another.
using Pieces = std::function<void(const std::function<void(std::string_view piece)>& put)>;
void write_new_file(const std::filesystem::path& path, const Pieces& pieces);
void make_folder(const std::filesystem::path& path, mode_t mode = 0777);
// Not if somebody else has made it by now, which is told by false.
bool make_missing_folder(const std::filesystem::path& path);
// With all in it, also where its owner may not write; what cannot be removed stays.
void remove_tree(const std::filesystem::path& path);
// The one before may have removed the file since it was opened; a lock on a file without a name keeps nobody out.
bool is_still_named(const Descriptor& file, const std::filesystem::path& path);
void sync_folder(const std::filesystem::path& path);  // its list of names is on the disk when it returns

}  // namespace pmreport::document
