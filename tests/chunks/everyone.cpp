// Work of which what comes next is needed wherever it goes on.
#include <core/chunks/agreed.hpp>
#include <tests/chunks/two_ranks.hpp>
#include <tests/host/fixtures/temporary.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <filesystem>

using namespace pmreport::chunks;

namespace {

const Work numbers{"numbers", 7, 9, true};

// The sum of the numbers of all chunks.
std::size_t sum(const Sharing& sharing) {
  std::size_t out = 0;
  run(
      numbers, sharing,
      [](std::size_t k) {
        Writer w;
        w.put(k);
        return w.take();
      },
      [&](std::size_t, std::span<const std::byte> answers) {
        std::size_t k = 0;
        Reader(answers).get(k);
        out += k;
      });
  return out;
}

}  // namespace

TEST_CASE("ranks that wait for each other both have all answers, each of which one of them computed") {
  const TemporaryFolder here;
  std::array<std::size_t, 2> sums{};
  std::array<Account, 2> accounts;
  TwoRanks().run([&](std::size_t rank, Dealer& dealer) {
    sums[rank] = sum({.folder = here.path(), .known = true, .dealer = &dealer, .account = &accounts[rank]});
  });
  CHECK(sums == std::array<std::size_t, 2>{36, 36});
  CHECK(accounts[0].computed == 5);
  CHECK(accounts[1].computed == 4);
}

TEST_CASE("a shard leaves what everyone needs to the merge, which computes it") {
  const TemporaryFolder here;
  Shard shard(0, 2);
  Account of_shard, of_merge;
  CHECK_THROWS_AS(sum({.folder = here.path(), .known = true, .dealer = &shard, .account = &of_shard}), Elsewhere);
  CHECK(of_shard.computed == 0);
  CHECK_THROWS_AS(leave_unless_waiting({.dealer = &shard}), Elsewhere);
  const Sharing merge{.folder = here.path(), .known = true, .computes = false, .account = &of_merge, .keep_after = 0};
  CHECK(sum(merge) == 36);
  CHECK(of_merge.computed == numbers.count);
  // One that is there and not as it was written is no reason to give up either.
  REQUIRE_FALSE(std::filesystem::is_empty(here.path()));
  const std::filesystem::path folder = std::filesystem::directory_iterator(here.path())->path();
  std::filesystem::resize_file(folder / "3", 10);
  CHECK(sum(merge) == 36);
  CHECK(of_merge.damaged == 1);
}

TEST_CASE("ranks that would decide otherwise agree, once and again") {
  const TemporaryFolder here;
  std::array<std::array<bool, 3>, 2> said{};
  TwoRanks().run([&](std::size_t rank, Dealer& dealer) {
    const Sharing sharing{.folder = here.path(), .known = true, .dealer = &dealer};
    for (std::size_t k = 0; k < 3; ++k) said[rank][k] = agreed(sharing, "decision", k, [&] { return (rank + k) % 2 == 1; });
  });
  CHECK(said[0] == said[1]);
  CHECK(said[0][0] != said[0][1]);  // by the same rank each time
}

TEST_CASE("one who shares nothing decides alone, and keeps nothing") {
  const TemporaryFolder here;
  const Sharing alone{.folder = here.path(), .known = true, .keep_after = 0};
  for (const bool yes : {true, false, true}) CHECK(agreed(alone, "decision", 1, [yes] { return yes; }) == yes);
  CHECK(std::filesystem::is_empty(here.path()));
}
