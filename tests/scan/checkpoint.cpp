// A scan that was stopped goes on where it was, and takes no file for its own that is not.
#include <tests/scan/sets.hpp>

#include <sys/resource.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace sets;
using scan::Checkpoint;
using scan::CheckpointError;
using scan::count_grid;
using scan::GridCounts;
using scan::GridOptions;
namespace fs = std::filesystem;

namespace {

struct Stop {};

// A folder of its own, gone at the end.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("pmreport-checkpoint-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    fs::permissions(path, fs::perms::owner_all, ignored);
    fs::remove_all(path, ignored);
  }
};

const program::Program& sign() {
  static const program::Program p = plane();
  return p;
}

// Some hundred steps: more than are done between two looks at the watch.
struct Case {
  scan::PoseSet set = three_legs();
  scan::Scan s{{0, 0, 0, 0, 0}, {{0, -1.5, 1.5, 49}, {1, -1.5, 1.5, 49}, {2, 1.5, -1.5, 33}}, {4, 3}, {{0, 0}, {0.5, 0.25}, {-0.5, 0.125}}};
  GridOptions options;
  Folder folder;
  fs::path file = folder.path / "scan";

  Case() {
    options.sign = &sign();
    options.keep_poses = true;
  }
  // Until the watch has been asked `looks` times.
  GridCounts run(bool resume, int looks = -1) {
    options.checkpoint = Checkpoint{file, resume, 7};
    scan::Watch watch;
    watch.stop_if_asked = [n = looks]() mutable {
      if (n-- == 0) throw Stop();
    };
    return count_grid(set, s, options, watch);
  }
  std::string bytes() const {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void write(const std::string& bytes) const { std::ofstream(file, std::ios::binary) << bytes; }
};

}  // namespace

TEST_CASE("a scan that is stopped again and again, at every look at the watch, ends with the same counts") {
  for (const bool prune : {true, false}) {
    Case c;
    c.options.prune = prune;
    const GridCounts whole = count_grid(c.set, c.s, c.options);
    GridCounts out;
    int runs = 0;
    for (bool stopped = true; stopped; ++runs) {
      stopped = false;
      try {
        out = c.run(true, 1);
      } catch (const Stop&) {
        stopped = true;
      }
    }
    CAPTURE(prune);
    CHECK(runs > 5);
    check_same(out, whole);
    CHECK(whole.tally.accepted > 1000);
    CHECK(!fs::exists(c.file.string() + ".part"));
  }
}

TEST_CASE("a scan that is not to be resumed begins anew, whatever the file holds") {
  Case c;
  CHECK_THROWS_AS(c.run(false, 2), Stop);
  const GridCounts whole = count_grid(c.set, c.s, c.options);
  check_same(c.run(false), whole);
  c.write("something else");
  check_same(c.run(false), whole);
}

TEST_CASE("a file of another scan, another version, or none of a scan is refused, and told how to go on") {
  Case c;
  CHECK_THROWS_AS(c.run(false, 2), Stop);
  const std::string good = c.bytes();
  const auto refused = [&](const char* word) {
    CHECK_THROWS_AS(c.run(true), CheckpointError);
    CHECK_THROWS_WITH(c.run(true), Catch::Contains(word) && Catch::Contains("remove it, or run without --resume"));
  };
  const auto changed = [&](std::size_t at) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(bytes[at] ^ 1);
    c.write(bytes);
  };
  changed(0);
  refused("not what a scan keeps");
  changed(7);
  refused("version");
  changed(8);
  refused("another scan");
  c.write(good);
  c.s.points[0].count += 1;
  refused("another scan");
  c.s.points[0].count -= 1;
  c.options.reasons = false;
  refused("another scan");
  c.options.reasons = true;
  c.options.keep_poses = false;
  refused("another scan");
  fs::remove(c.file);
  fs::create_directory(c.file);
  refused("cannot be read");
}

TEST_CASE("a damaged file is refused: any bit, anything that is missing, anything too much") {
  constexpr std::uint64_t seed = 74;
  Random random(seed);
  Case c;
  CHECK_THROWS_AS(c.run(false, 2), Stop);
  const std::string good = c.bytes();
  for (int trial = 0; trial < 60; ++trial) {
    std::string bytes = good;
    const auto at = static_cast<std::size_t>(random.within(32, static_cast<double>(good.size())));
    if (trial % 3 == 0) bytes[at] = static_cast<char>(bytes[at] ^ (1 << trial % 8));
    if (trial % 3 == 1) bytes.resize(at);
    if (trial % 3 == 2) bytes.append(at, '\0');
    c.write(bytes);
    CAPTURE(seed, trial, at);
    CHECK_THROWS_WITH(c.run(true), Catch::Contains("is damaged") && Catch::Contains("remove it, or run without --resume"));
  }
  c.write("");
  CHECK_THROWS_WITH(c.run(true), Catch::Contains("ends too early"));
  c.write(good);
  CHECK_NOTHROW(c.run(true));
}

TEST_CASE("a folder that cannot be written, and a disk without room, are told, and the old file stays") {
  Case c;
  std::ofstream(c.folder.path / "a file") << "where a folder would have to be";
  c.file = c.folder.path / "a file" / "scan";
  CHECK_THROWS_AS(c.run(false, 2), CheckpointError);
  CHECK_THROWS_WITH(c.run(false, 2), Catch::Contains("cannot be kept") && Catch::Contains("make room"));

  c.file = c.folder.path / "scan";
  CHECK_THROWS_AS(c.run(false, 1), Stop);
  const std::string good = c.bytes();
  // No file may grow beyond half of what is to be written: a write stops half-way, as it does where a disk is full.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = good.size() / 2;
  setrlimit(RLIMIT_FSIZE, &small);
  bool told = false;
  try {
    c.run(true, 1);
  } catch (const CheckpointError&) {
    told = true;
  } catch (const Stop&) {
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK(told);
  CHECK(c.bytes() == good);
  CHECK(!fs::exists(c.file.string() + ".part"));
}
