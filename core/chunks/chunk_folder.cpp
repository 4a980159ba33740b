#include <core/chunks/chunk_folder.hpp>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <random>
#include <span>
#include <system_error>

namespace pmreport::chunks {

namespace {

constexpr std::array<char, 8> beginning{'p', 'm', 'c', 'h', 'u', 'n', 'k', '1'};  // the last is the version of the format
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 32;                      // of one chunk; a file that says more is none

// Before the answers; after them stands the checksum of both. Numbers are as this machine has them: where they are the other way round, the
// beginning of another work is seen.
struct Head {
  std::array<char, 8> magic;
  std::uint64_t meaning, chunk, bytes;
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

template <class T>
std::span<std::byte> bytes_of(T& x) {
  return std::as_writable_bytes(std::span(&x, 1));
}

// Closed at the end of its life.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
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

// Letters, digits and dashes of a name; works that differ elsewhere have other meanings.
std::string plain(const std::string& name) {
  constexpr std::size_t longest = 60;
  std::string out = name.substr(0, longest);
  for (char& c : out)
    if (!((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'))) c = '-';
  return out;
}

}  // namespace

ChunkFolder::ChunkFolder(const std::filesystem::path& folder, std::uint64_t of_run, const Work& work)
    : meaning_((Meaning() << of_run << work.meaning << work.count).value()) {
  folder_ = folder / fmt::format("{}-{:016x}", plain(work.name), meaning_);
}

std::filesystem::path ChunkFolder::file(std::size_t chunk) const { return folder_ / fmt::format("{}", chunk); }

bool ChunkFolder::has(std::size_t chunk) const { return ::access(file(chunk).c_str(), F_OK) == 0; }

std::optional<Bytes> ChunkFolder::load(std::size_t chunk, bool& damaged) const {
  damaged = false;
  const std::filesystem::path path = file(chunk);
  const auto unreadable = [&] {
    throw ChunkError(fmt::format("{} cannot be read ({}): remove it, and it will be computed again", path.string(),
                                 std::generic_category().message(errno)));
  };
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe of that name would wait for ever
  if (!file.good() && (errno == ENOENT || errno == ENOTDIR)) return std::nullopt;
  struct stat about {};
  if (!file.good() || ::fstat(file.number(), &about) != 0) unreadable();
  damaged = true;  // until all of it is seen
  Head head{};
  std::uint64_t expected = 0;
  if (!S_ISREG(about.st_mode) || about.st_size < static_cast<off_t>(sizeof head + sizeof expected)) return std::nullopt;
  const auto read = [&](std::span<std::byte> to) {
    const ssize_t n = file.read(to);
    if (n < 0) unreadable();
    return static_cast<std::size_t>(n) == to.size();
  };
  if (!read(bytes_of(head)) || head.magic != beginning || head.meaning != meaning_ || head.chunk != chunk || head.bytes > most_bytes ||
      static_cast<std::uint64_t>(about.st_size) != sizeof head + head.bytes + sizeof expected)
    return std::nullopt;
  Bytes out(static_cast<std::size_t>(head.bytes));
  if (!read(out) || !read(bytes_of(expected))) return std::nullopt;
  Checksum sum;
  sum.add(bytes_of(head));
  sum.add(out);
  if (sum.sum() != expected) return std::nullopt;
  damaged = false;
  return out;
}

void ChunkFolder::keep(std::size_t chunk, const Bytes& bytes) const {
  const std::filesystem::path path = file(chunk);
  // A name of its own: the same chunk may be kept by two at once, on two machines.
  std::random_device random;
  const std::string fresh = fmt::format("{}.part-{:08x}{:08x}", path.string(), random(), random());
  const auto fail = [&](bool made) {
    const int error = errno;
    if (made) ::unlink(fresh.c_str());
    throw ChunkNotKept(fmt::format("what is done cannot be kept in {} ({}): make room there, or name a folder that can be written",
                                   path.string(), std::generic_category().message(error)));
  };
  // A folder that cannot be made is told by the file that cannot be written in it.
  std::error_code not_made;
  std::filesystem::create_directories(folder_, not_made);
  Head head{beginning, meaning_, chunk, bytes.size()};
  Checksum sum;
  sum.add(bytes_of(head));
  sum.add(bytes);
  std::uint64_t last = sum.sum();
  {
    const Descriptor file(::open(fresh.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.good()) fail(false);
    // Not to the disk at once: what a failing machine loses of it is seen by the checksum, and done again.
    if (!file.write(bytes_of(head)) || !file.write(bytes) || !file.write(bytes_of(last))) fail(true);
  }
  if (::rename(fresh.c_str(), path.c_str()) != 0) fail(true);
}

}  // namespace pmreport::chunks
