#include <core/chunks/chunk_folder.hpp>
#include <core/chunks/sharing.hpp>
#include <tests/fuzz/chunk.hpp>
#include <tests/fuzz/corpus.hpp>
#include <tests/host/fixtures/temporary.hpp>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

namespace fs = std::filesystem;
using namespace pmreport::chunks;
using Catch::Matchers::Contains;

namespace {

constexpr std::size_t count = 23;
const Work squares{"squares", 7, count};

// The squares of all numbers, joined; and how many of them were computed for it.
struct Seen {
  std::string text;
  std::size_t computed = 0, damaged = 0;
};
Seen run_squares(Sharing sharing, const Work& work = squares) {
  Account account;
  sharing.account = &account;
  Seen out;
  run(
      work, sharing,
      [](std::size_t k) {
        Writer w;
        w.put(std::to_string(k * k));
        return w.take();
      },
      [&](std::size_t k, std::span<const std::byte> answers) {
        Reader r(answers);
        std::string text;
        r.get(text);
        r.end();
        out.text += std::to_string(k) + ":" + text + " ";
      });
  out.computed = account.computed;
  out.damaged = account.damaged;
  return out;
}

Sharing kept_in(const fs::path& folder) { return {.folder = folder, .known = true, .keep_after = 0}; }

fs::path file_of(const fs::path& folder, std::size_t chunk) { return fs::directory_iterator(folder)->path() / std::to_string(chunk); }

void run_shard(const fs::path& folder, std::size_t index, std::size_t of, const Work& work = squares) {
  Shard shard(index, of);
  Sharing sharing = kept_in(folder);
  sharing.dealer = &shard;
  CHECK_THROWS_AS(run_squares(sharing, work), Elsewhere);
}

}  // namespace

TEST_CASE("answers are taken in the order of their chunks by any number of threads") {
  std::string expected;
  for (std::size_t k = 0; k < count; ++k) expected += std::to_string(k) + ":" + std::to_string(k * k) + " ";
  for (const std::size_t threads : {1u, 2u, 5u}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    const Seen seen = run_squares({});
    CHECK(seen.text == expected);
    CHECK(seen.computed == count);
  }
}

TEST_CASE("shards that each do a part give together what one process gives") {
  const TemporaryFolder here;
  const std::string alone = run_squares({}).text;
  for (const std::size_t shard : {2u, 0u, 1u}) {
    Sharing merged = kept_in(here.path());
    merged.computes = false;
    CHECK_THROWS_WITH(run_squares(merged), Contains("chunks of squares are missing") && Contains("run the shards that have not ended"));
    run_shard(here.path(), shard, 3);
  }
  Sharing merged = kept_in(here.path());
  merged.computes = false;
  const Seen seen = run_squares(merged);
  CHECK(seen.text == alone);
  CHECK(seen.computed == 0);
}

TEST_CASE("of two works that are alike but for their names each is dealt from its beginning") {
  const TemporaryFolder here;
  Shard shard(0, 2);
  Sharing sharing = kept_in(here.path());
  sharing.dealer = &shard;
  Work other = squares;
  other.name = "others";
  for (const Work& w : {squares, other}) CHECK_THROWS_AS(run_squares(sharing, w), Elsewhere);
  Sharing resumed = kept_in(here.path());
  CHECK(run_squares(resumed).computed == count / 2);
  CHECK(run_squares(resumed, other).computed == count / 2);
}

TEST_CASE("what is there already is not computed again, and what is missing is") {
  const TemporaryFolder here;
  const Seen whole = run_squares(kept_in(here.path()));
  CHECK(whole.computed == count);
  fs::remove(file_of(here.path(), 3));
  fs::remove(file_of(here.path(), 11));
  const Seen resumed = run_squares(kept_in(here.path()));
  CHECK(resumed.computed == 2);
  CHECK(resumed.text == whole.text);
  Sharing anew = kept_in(here.path());
  anew.known = false;
  CHECK(run_squares(anew).computed == count);
  anew.computes = false;
  CHECK(run_squares(anew).computed == 0);
}

TEST_CASE("a chunk of which any byte is another, that ends early or goes on is computed again") {
  const TemporaryFolder here;
  const std::string expected = run_squares(kept_in(here.path())).text;
  const fs::path file = file_of(here.path(), 12);
  const std::string good = read_bytes(file);
  REQUIRE(good.size() > 40);
  const auto check = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    const Seen seen = run_squares(kept_in(here.path()));
    CHECK(seen.damaged == 1);
    CHECK(seen.computed == 1);
    CHECK(seen.text == expected);
    CHECK(read_bytes(file) == good);
  };
  for (std::size_t k = 0; k < good.size(); ++k) {
    std::string bytes = good;
    bytes[k] = static_cast<char>(bytes[k] ^ (1 << (k % 8)));
    check(bytes);
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, good.size() - 1}) check(good.substr(0, size));
  check(good + "x");
  std::ofstream(file, std::ios::binary) << read_bytes(file_of(here.path(), 13));  // whole, and another chunk's
  Sharing merged = kept_in(here.path());
  merged.computes = false;
  CHECK_THROWS_WITH(run_squares(merged), Contains("chunk 12 of squares") && Contains("is damaged"));
}

TEST_CASE("chunks of other work, or of another program, count for nothing") {
  const TemporaryFolder here;
  run_squares(kept_in(here.path()));
  Work other = squares;
  other.meaning = 8;
  CHECK(run_squares(kept_in(here.path()), other).computed == count);
  Sharing later = kept_in(here.path());
  later.of_run = 1;
  CHECK(run_squares(later).computed == count);
}

TEST_CASE("a chunk that cannot be kept is told, with what to do") {
  const TemporaryFolder here;
  here.write("file", "");
  CHECK_THROWS_AS(run_squares(kept_in(here.path() / "file")), ChunkNotKept);
  CHECK_THROWS_WITH(run_squares(kept_in(here.path() / "file")), Contains("cannot be kept") && Contains("make room there"));
}

TEST_CASE("a run that is stopped keeps what is done, and nothing half") {
  const TemporaryFolder here;
  std::atomic<int> asked{0};
  struct Stopped {};
  const Watch stop{[](double) {},
                   [&] {
                     if (++asked > 9) throw Stopped();
                   }};
  const auto compute = [](std::size_t k) { return Bytes(k + 1); };
  CHECK_THROWS_AS(run(
                      squares, kept_in(here.path()), compute, [](std::size_t, std::span<const std::byte>) {}, stop),
                  Stopped);
  std::size_t kept = 0;
  for (const auto& e : fs::directory_iterator(fs::directory_iterator(here.path())->path())) {
    CHECK_THAT(e.path().filename().string(), !Contains("part"));
    ++kept;
  }
  CHECK(kept > 0);
  CHECK(kept <= 9);
}

TEST_CASE("a chunk whose loops run while another one throws is kept whole or not at all") {
  const TemporaryFolder here;
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 2);
  struct Stop {};
  std::atomic<bool> begun = false;
  // The first chunk throws while the second one counts to a hundred.
  const auto counted = [&](bool throws) {
    std::uint64_t out = 0;
    run(
        {"counts", 7, 2}, kept_in(here.path()),
        [&](std::size_t k) {
          for (int i = 0; throws && k == 0; ++i) {
            if (begun || i == 1000) throw Stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
          std::atomic<std::uint64_t> sum = 0;
          tbb::parallel_for(0, 100, [&](int) {
            begun = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            ++sum;
          });
          Writer w;
          w.put(sum.load());
          return w.take();
        },
        [&](std::size_t, std::span<const std::byte> answers) {
          std::uint64_t one = 0;
          Reader(answers).get(one);
          out += one;
        });
    return out;
  };
  CHECK_THROWS_AS(counted(true), Stop);
  CHECK(counted(false) == 200);
}

TEST_CASE("numbers and texts come back from bytes as they were, and too few bytes are told") {
  Writer w;
  const std::vector<std::uint32_t> counts{0, 0, 0, 5, 5, 300, 4'000'000'000u};
  w.put(-0.0);
  w.put(std::string("a\0b", 3));
  w.put(std::vector<double>{1.5, -2});
  w.put_runs(std::span<const std::uint32_t>(counts));
  w.put(true);
  const Bytes bytes = w.take();
  const auto read = [&](std::span<const std::byte> from) {
    Reader r(from);
    double zero = 1;
    std::string text;
    std::vector<double> numbers;
    std::vector<std::uint32_t> back(counts.size());
    bool yes = false;
    r.get(zero);
    r.get(text);
    r.get(numbers);
    r.get_runs(std::span(back));
    r.get(yes);
    r.end();
    CHECK((zero == 0 && std::signbit(zero)));
    CHECK(text == std::string("a\0b", 3));
    CHECK(numbers == std::vector<double>{1.5, -2});
    CHECK(back == counts);
    CHECK(yes);
  };
  read(bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size) CHECK_THROWS_AS(read(std::span(bytes).first(size)), NotReadable);
  Bytes more = bytes;
  more.push_back({});
  CHECK_THROWS_AS(read(more), NotReadable);
}

TEST_CASE("no chunk of the fuzzer's corpus, and none made of them, breaks a promise") {
  fuzz::check_promises("chunk", fuzz::broken_by_chunk);
}
