#include <core/scan/checkpoint_file.hpp>

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace pmreport::scan {

namespace {

constexpr char beginning[8] = {'p', 'm', 's', 'c', 'a', 'n', '\n', '1'};  // the last is the version of the format

// Before the state; after it stands the checksum of both. Numbers are as this machine has them: where they are the other way round, the
// scan is none that is known.
struct Head {
  std::array<char, 8> magic;
  std::uint64_t scan, form, bytes;
};
static_assert(sizeof(Head) == 32);

// Each word is mixed in, and the sum multiplied by an odd number, neither of which loses anything: a change of any one word is seen.
class Checksum {
 public:
  void add(std::span<const std::byte> bytes) {
    for (std::size_t k = 0; k < bytes.size(); k += sizeof(std::uint64_t)) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes.data() + k, std::min(sizeof word, bytes.size() - k));
      sum_ = (sum_ ^ word) * 0x9E3779B97F4A7C15u;
      sum_ ^= sum_ >> 32;
    }
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0x2545F4914F6CDD1Du;
};

// Closed at the end of its life.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool good() const { return number_ >= 0; }
  int number() const { return number_; }
  bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t n = ::write(number_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n == 0) errno = ENOSPC;
      if (n <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(n));
    }
    return true;
  }
  // How many bytes there were, up to as many as were asked for; negative: it cannot be read.
  ssize_t read(std::span<std::byte> bytes) const {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t n = ::read(number_, bytes.data() + done, bytes.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) return n;
      if (n == 0) break;
      done += static_cast<std::size_t>(n);
    }
    return static_cast<ssize_t>(done);
  }

 private:
  int number_;
};

template <class T>
std::span<std::byte> bytes_of(T& x) {
  return std::as_writable_bytes(std::span(&x, 1));
}

std::uint64_t size_of(const ScanState& state) {
  std::uint64_t n = 0;
  for (const auto& part : state) n += part.size();
  return n;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw CheckpointError(fmt::format("{} {}: remove it, or run without --resume", file.string(), why));
}

}  // namespace

bool CheckpointFile::load(const ScanState& state) const {
  if (!checkpoint_.resume) return false;
  const std::filesystem::path& path = checkpoint_.file;
  const Descriptor file(path, O_RDONLY);
  if (!file.good() && errno == ENOENT) return false;
  const auto unreadable = [&] { refuse(path, fmt::format("cannot be read ({})", std::generic_category().message(errno))); };
  if (!file.good()) unreadable();
  const auto read = [&](std::span<std::byte> to) {
    const ssize_t n = file.read(to);
    if (n < 0) unreadable();
    if (static_cast<std::size_t>(n) < to.size()) refuse(path, "is damaged: it ends too early");
  };
  Head head{};
  Checksum sum;
  read(bytes_of(head.magic));
  if (std::memcmp(head.magic.data(), beginning, sizeof beginning - 1) != 0) refuse(path, "is not what a scan keeps");
  if (head.magic.back() != beginning[7]) refuse(path, "was kept by another version of pmreport");
  read(bytes_of(head).subspan(sizeof head.magic));
  if (head.scan != checkpoint_.scan || head.form != form_ || head.bytes != size_of(state))
    refuse(path, "holds another scan, or this one with other limits, ranges or counts");
  sum.add(bytes_of(head));
  for (const auto& part : state) {
    read(part);
    sum.add(part);
  }
  std::uint64_t expected = 0;
  read(bytes_of(expected));
  if (sum.sum() != expected) refuse(path, "is damaged: its contents are not those that were written");
  char more = 0;
  if (file.read(bytes_of(more)) != 0) refuse(path, "is damaged: it goes on behind its end");
  return true;
}

void CheckpointFile::save(const ScanState& state) {
  const Clock::time_point start = Clock::now();
  std::filesystem::path fresh = checkpoint_.file;
  fresh += ".part";
  const auto fail = [&] {
    const int error = errno;
    ::unlink(fresh.c_str());
    throw CheckpointNotKept(
        fmt::format("what is done of the scan cannot be kept in {} ({}): make room there, or name a folder that can be written",
                    checkpoint_.file.string(), std::generic_category().message(error)));
  };
  // A folder that cannot be made is told by the file that cannot be written in it.
  std::error_code not_made;
  std::filesystem::create_directories(checkpoint_.file.parent_path(), not_made);
  Head head{{}, checkpoint_.scan, form_, size_of(state)};
  std::memcpy(head.magic.data(), beginning, sizeof beginning);
  Checksum sum;
  sum.add(bytes_of(head));
  {
    const Descriptor file(fresh, O_WRONLY | O_CREAT | O_TRUNC);
    if (!file.good() || !file.write(bytes_of(head))) fail();
    for (const auto& part : state) {
      sum.add(part);
      if (!file.write(part)) fail();
    }
    std::uint64_t last = sum.sum();
    if (!file.write(bytes_of(last)) || ::fsync(file.number()) != 0) fail();
  }
  if (::rename(fresh.c_str(), checkpoint_.file.c_str()) != 0) fail();
  saved_ = Clock::now();
  seconds_to_save_ = std::chrono::duration<double>(saved_ - start).count();
}

}  // namespace pmreport::scan
