// Scans in chunks: the same counts however the work is spread, and after whatever went wrong with what was kept.
#include <tests/host/fixtures/temporary.hpp>
#include <tests/scan/sets.hpp>

#include <sys/resource.h>
#include <tbb/global_control.h>
#include <catch2/catch.hpp>
#include <core/chunks/chunk_folder.hpp>
#include <core/scan/judge/walk.hpp>
#include <core/scan/monte_carlo.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace sets;
using chunks::Sharing;
using scan::count_grid;
using scan::Estimate;
using scan::GridCounts;
using scan::GridOptions;
using scan::monte_carlo;
using scan::MonteCarloOptions;
namespace fs = std::filesystem;

namespace {

struct Stop {};

const program::Program& sign() {
  static const program::Program p = plane();
  return p;
}

// Both are above zero where x is near 0.5 and the turn is not far from 0.
scan::LateMargins late_margins(std::size_t every) {
  return {2,
          [](std::size_t count, const double* poses, double* out) {
            for (std::size_t k = 0; k < count; ++k) {
              const double x = poses[k], turn = poses[4 * count + k];
              out[k] = 0.75 - (x - 0.5) * (x - 0.5);
              out[count + k] = turn + 0.25 + 0.5 * x;
            }
          },
          every};
}

struct Grid {
  scan::PoseSet set = three_legs();
  scan::Scan s{{0, 0, 0, 0, 0}, {}, {4, 3}, {}};
  GridOptions options;

  Grid() { options.sign = &sign(), options.keep_poses = true; }
  void turn(std::size_t orientations) {
    Random random(75);
    for (std::size_t k = 0; k < orientations; ++k) s.orientations.push_back({random.within(-1, 1), random.within(-0.5, 0.5)});
  }
  void add_late(std::size_t every) {
    set.late = late_margins(every);
    set.rounding.insert(set.rounding.end(), {1e-12, 1e-12});
  }
  GridCounts count(const Sharing& sharing = {}, const scan::Watch& watch = {}) const {
    return count_grid(set, s, options, watch, {"a grid", 7}, sharing);
  }
};

// A million poses, few orientations: some chunks of whole tiles.
Grid of_points() {
  Grid out;
  out.s.points = {{0, -1.5, 1.5, 97}, {1, -1.5, 1.5, 65}, {2, 1.5, -1.5, 57}};
  out.turn(3);
  return out;
}
// Few points, and orientations of which thousands are prepared at a time: a chunk goes through some such groups.
Grid of_orientations() {
  Grid out;
  out.s.points = {{2, 0.875, 1.25, 2}, {0, -0.25, 0.75, 4}, {1, -0.5, 0.25, 3}};
  out.turn(60000);
  return out;
}
// Late margins, one of which must hold at every orientation: smaller chunks, whose answers are of two kinds.
Grid of_late(std::size_t every = 1) {
  Grid out;
  out.s.points = {{0, -1.5, 1.5, 49}, {1, -1.5, 1.5, 33}, {2, 1.5, -1.5, 33}};
  out.turn(4);
  out.add_late(every);
  return out;
}

MonteCarloOptions random_poses(std::uint64_t seed = 3) { return {30000, seed, true}; }
scan::Scan range() { return {{0, 0, 0, 0.1, 0.2}, {{2, -1.5, 1.5}, {0, 1.5, -1.5}, {1, -0.75, 0.75}}, {4, 3}, {{0, 0}, {0.5, 0.25}}}; }
Estimate estimate(const Sharing& sharing = {}, const scan::Watch& watch = {}, const MonteCarloOptions& options = random_poses(),
                  const scan::Scan& s = range(), std::size_t need = 1) {
  return monte_carlo(three_legs(), s, need, options, watch, {"random poses", 7}, sharing);
}

using sets::check_same;
void check_same(const Estimate& a, const Estimate& b) {
  for (const auto number : {&scan::Tally::poses, &scan::Tally::accepted, &scan::Tally::on_a_limit})
    CHECK(a.tally.*number == b.tally.*number);
  CHECK(a.tally.first == b.tally.first);
  CHECK(a.tally.any == b.tally.any);
  CHECK(a.share == b.share);
  CHECK(a.low == b.low);
  CHECK(a.high == b.high);
}

Sharing kept_in(const fs::path& folder, chunks::Account& account) {
  return {.folder = folder, .of_run = 5, .known = true, .account = &account, .keep_after = 0};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) out.push_back(entry.path());
  std::ranges::sort(out);
  return out;
}

// All ways to spread and to lose some of it, of a scan that is run with a sharing and a watch.
template <class Run>
void check_shared(const Run& run) {
  const auto whole = run(Sharing{}, scan::Watch{});
  const TemporaryFolder folder;
  for (std::size_t index = 0; index < 3; ++index) {
    chunks::Account account;
    chunks::Shard shard(index, 3);
    Sharing sharing = kept_in(folder.path(), account);
    sharing.dealer = &shard;
    CHECK_THROWS_AS(run(sharing, scan::Watch{}), chunks::Elsewhere);
    CHECK(account.computed > 0);
    CHECK(account.found == 0);
  }
  const std::vector<fs::path> files = files_in(folder.path());
  REQUIRE(files.size() >= 3);
  {
    INFO("the shards' answers are put together");
    chunks::Account account;
    Sharing sharing = kept_in(folder.path(), account);
    sharing.computes = false;
    check_same(run(sharing, scan::Watch{}), whole);
    CHECK(account.found == files.size());
    CHECK(account.computed == 0);
  }
  {
    INFO("some are lost, one is damaged");
    fs::remove(files.front());
    fs::remove(files.back());
    std::string bytes = read_bytes(files[1]);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
    std::ofstream(files[1], std::ios::binary) << bytes;
    chunks::Account account;
    check_same(run(kept_in(folder.path(), account), scan::Watch{}), whole);
    CHECK(account.computed == 3);
    CHECK(account.damaged == 1);
    CHECK(account.found == files.size() - 3);
    CHECK(files_in(folder.path()) == files);
  }
  {
    INFO("stopped where some is done, again and again");
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 2);
    fs::remove_all(folder.path() / fs::relative(files.front(), folder.path()).begin()->string());
    std::size_t stops = 0;
    for (bool stopped = true; stopped; stops += stopped) {
      stopped = false;
      chunks::Account account;
      const std::size_t before = files_in(folder.path()).size();
      scan::Watch watch;
      watch.stop_if_asked = [&] {
        if (account.computed > 2) throw Stop();  // by two threads: one of the first two is kept
      };
      try {
        check_same(run(kept_in(folder.path(), account), watch), whole);
      } catch (const Stop&) {
        stopped = true;
        CHECK(files_in(folder.path()).size() > before);
      }
      CHECK(account.found == before);
    }
    CHECK(stops > 0);
  }
}

}  // namespace

TEST_CASE("a grid has the same counts by one thread and two, and from chunks that others computed, with and without pruning") {
  for (const Grid& grid : {of_points(), of_orientations(), of_late()}) {
    std::optional<GridCounts> first;
    for (const std::size_t threads : {1, 2})
      for (const bool prune : {true, false}) {
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        CAPTURE(threads, prune, grid.s.point_count(), grid.s.orientation_count());
        Grid g = grid;
        g.options.prune = prune;
        const GridCounts counts = g.count();
        if (!first) first = counts;
        check_same(counts, *first);
      }
    CHECK(first->tally.accepted > 1000);
    CHECK(first->positive > 100);
    CHECK(first->negative > 100);
  }
}

TEST_CASE("a grid that is shared, lost in part, or stopped and gone on with has the same counts") {
  for (Grid grid : {of_points(), of_orientations(), of_late()}) {
    CAPTURE(grid.s.point_count(), grid.s.orientation_count());
    check_shared([&](const Sharing& sharing, const scan::Watch& watch) { return grid.count(sharing, watch); });
  }
}

TEST_CASE("random poses that are shared, lost in part, or stopped and gone on with give the same estimate") {
  check_shared([](const Sharing& sharing, const scan::Watch& watch) { return estimate(sharing, watch); });
}

TEST_CASE("chunks whose tiles and groups meet within a word of kept poses count as poses one by one") {
  // 9 points of 8200 orientations: two whole groups, and one of eight.
  Grid grid;
  grid.s.points = {{0, -0.5, 0.75, 3}, {2, 0.875, 1, 1}, {1, -0.75, 0.5, 3}};
  grid.turn(8200);
  grid.add_late(0);
  const GridCounts expected = brute_force(grid.set, grid.s, grid.options);
  chunks::Account account;
  const TemporaryFolder folder;
  check_same(grid.count(kept_in(folder.path(), account)), expected);
  CHECK(account.computed > 1);
  CHECK(expected.positive > 100);
  CHECK(expected.negative > 100);
}

TEST_CASE("a chunk of a grid or of random poses of which any byte is another is computed again") {
  Grid small;
  small.set = shell(0.5, 1.0);
  small.s = {{0, 0, 0}, {{0, -1, 1, 5}, {1, -1, 1, 4}, {2, -1, 1, 3}}};
  small.options = {};
  const scan::Scan box{{0, 0, 0}, {{0, -1, 1}, {1, -1, 1}, {2, -1, 1}}};
  const auto check = [](const auto& run) {
    const auto whole = run(Sharing{});
    const TemporaryFolder folder;
    chunks::Account first;
    run(kept_in(folder.path(), first));
    const std::vector<fs::path> files = files_in(folder.path());
    REQUIRE(files.size() == 1);
    const std::string good = read_bytes(files.front());
    for (std::size_t at = 0; at < good.size(); ++at) {
      std::string bytes = good;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << at % 8));
      std::ofstream(files.front(), std::ios::binary) << bytes;
      chunks::Account account;
      const auto again = run(kept_in(folder.path(), account));
      CAPTURE(at);
      CHECK(account.damaged == 1);
      CHECK(account.computed == 1);
      CHECK(again.tally.accepted == whole.tally.accepted);
      CHECK(again.tally.any == whole.tally.any);
      CHECK(read_bytes(files.front()) == good);
    }
  };
  check([&](const Sharing& sharing) { return small.count(sharing); });
  check([&](const Sharing& sharing) { return monte_carlo(small.set, box, 1, {100, 1, true}, {}, {"random", 7}, sharing); });
}

TEST_CASE("chunks of another grid count for nothing: other limits, ranges, numbers, orientations, signs, or what is asked of them") {
  const TemporaryFolder folder;
  Grid grid;
  grid.s.points = {{0, -1, 1, 5}, {1, -1, 1, 4}};
  grid.turn(3);
  const auto found = [&](const Grid& g) {
    chunks::Account account;
    g.count(kept_in(folder.path(), account));
    return account.found.load();
  };
  CHECK(found(grid) == 0);
  CHECK(found(grid) == 1);
  const program::Program other_sign = recording::recorded(5, [](const std::vector<Recorded>& q) { return std::vector<Recorded>{q[0]}; });
  const auto changed = [&](const std::function<void(Grid&)>& change) {
    Grid g = grid;
    change(g);
    return found(g);
  };
  CHECK(changed([](Grid& g) { g.set.rounding[2] *= 2; }) == 0);
  CHECK(changed([](Grid& g) { g.s.points[0].to = 1.25; }) == 0);
  CHECK(changed([](Grid& g) { std::swap(g.s.points[0].count, g.s.points[1].count); }) == 0);
  CHECK(changed([](Grid& g) { g.s.points[1].input = 2; }) == 0);
  CHECK(changed([](Grid& g) { g.s.at[2] = 0.5; }) == 0);
  CHECK(changed([](Grid& g) { g.s.orientations[1][0] += 0.125; }) == 0);
  CHECK(changed([](Grid& g) { std::swap(g.s.turned[0], g.s.turned[1]); }) == 0);
  CHECK(changed([](Grid& g) { g.add_late(0); }) == 0);
  CHECK(changed([](Grid& g) { g.add_late(1); }) == 0);
  CHECK(changed([](Grid& g) { g.options.reasons = false; }) == 0);
  CHECK(changed([](Grid& g) { g.options.keep_poses = false; }) == 0);
  CHECK(changed([](Grid& g) { g.options.sign = nullptr; }) == 0);
  CHECK(changed([&](Grid& g) { g.options.sign = &other_sign; }) == 0);
  CHECK(changed([](Grid& g) {
          g.set.margins = recording::recorded(
              5, [](const std::vector<Recorded>& q) { return std::vector<Recorded>(three_legs().size(), 1.0 - q[0] * q[0]); });
        }) == 0);
  CHECK(changed([](Grid& g) { g.options.prune = false; }) == 1);  // which decides nothing

  chunks::Account account;
  const Sharing sharing = kept_in(folder.path(), account);
  count_grid(grid.set, grid.s, grid.options, {}, {"a grid", 8}, sharing);  // what late margins are made from
  CHECK(account.found == 0);
}

TEST_CASE("chunks of other random poses count for nothing: another seed, number, need or range") {
  const TemporaryFolder folder;
  const auto found = [&](const MonteCarloOptions& options, const scan::Scan& s = range(), std::size_t need = 1) {
    chunks::Account account;
    estimate(kept_in(folder.path(), account), {}, options, s, need);
    return account.found.load();
  };
  MonteCarloOptions options{2000, 3, true};
  CHECK(found(options) == 0);
  CHECK(found(options) == 1);
  CHECK(found({2000, 4, true}) == 0);
  CHECK(found({2001, 3, true}) == 0);
  CHECK(found({2000, 3, false}) == 0);
  CHECK(found(options, range(), 2) == 0);
  scan::Scan wider = range();
  wider.points[0].to = 2;
  CHECK(found(options, wider) == 0);
}

TEST_CASE("a scan is asked to stop within a chunk, and keeps nothing of it") {
  const TemporaryFolder folder;
  std::atomic<int> looks = 0;
  scan::Watch watch;
  watch.stop_if_asked = [&] {
    if (++looks == 10) throw Stop();
  };
  chunks::Account account;
  Grid grid;
  grid.s.points = {{0, -1.5, 1.5, 17}, {1, -1.5, 1.5, 33}, {2, 1.5, -1.5, 33}};
  CHECK_THROWS_AS(grid.count(kept_in(folder.path(), account), watch), Stop);
  CHECK(account.computed == 1);
  looks = 0;
  scan::Scan turned = range();
  for (int k = 0; k < 20; ++k) turned.orientations.push_back(turned.orientations.front());
  CHECK_THROWS_AS(estimate(kept_in(folder.path(), account), watch, {1000, 1, true}, turned), Stop);
  CHECK(account.computed == 2);
  CHECK(files_in(folder.path()).empty());
}

TEST_CASE("a walk that was stopped at any moment leaves nothing behind for the next one") {
  Grid grid;
  grid.s.points = {{0, -1.5, 1.5, 17}, {1, -1.5, 1.5, 17}, {2, 1.5, -1.5, 17}};
  grid.turn(4);
  const scan::Plan plan(grid.set, grid.s, false, grid.options.sign);
  const scan::Orientations orientations(plan, 0, 4);
  const scan::Tile tile = scan::Tile::whole(grid.s);
  for (const bool prune : {true, false}) {
    int looks = 0, stop_at = 0;
    scan::Walk walk(plan, prune, [&] {
      if (++looks == stop_at) throw Stop();
    });
    const auto run = [&] {
      std::vector<std::uint64_t> bits((tile.size() * 4 + 63) / 64);
      scan::Found found = walk.run(tile, orientations, 0, {bits.data(), bits.data(), bits.data()});
      std::uint64_t marked = 0;
      for (const std::uint64_t word : bits) marked += static_cast<std::uint64_t>(std::popcount(word));
      CHECK(marked == found.tally.accepted);
      return found;
    };
    const scan::Found whole = run();
    const int all = looks;
    CHECK(all > 3);
    CHECK(whole.tally.accepted > 100);
    for (stop_at = 1; stop_at <= all; ++stop_at) {
      looks = 0;
      CHECK_THROWS_AS(run(), Stop);
      const scan::Found after = run();
      CAPTURE(prune, stop_at);
      CHECK(after.tally.accepted == whole.tally.accepted);
      CHECK(after.positive == whole.positive);
      CHECK(after.negative == whole.negative);
      CHECK((after.accepted == whole.accepted));
    }
  }
}

TEST_CASE("a disk without room is told, and what was kept before stays") {
  const TemporaryFolder folder;
  Grid grid;
  grid.s.points = {{0, -1, 1, 17}, {1, -1, 1, 17}, {2, -1, 1, 17}};
  chunks::Account account;
  const Sharing sharing = kept_in(folder.path(), account);
  const GridCounts whole = grid.count(sharing);
  const std::vector<fs::path> files = files_in(folder.path());
  REQUIRE(files.size() == 1);
  const std::string good = read_bytes(files.front());
  Sharing anew = sharing;
  anew.known = false;
  // No file may grow beyond half of what is to be written: a write stops half-way, as it does where a disk is full.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = good.size() / 2;
  setrlimit(RLIMIT_FSIZE, &small);
  std::string told;
  try {
    grid.count(anew);
  } catch (const chunks::ChunkNotKept& e) {
    told = e.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  CHECK_THAT(told, Catch::Contains("cannot be kept") && Catch::Contains("make room"));
  CHECK(files_in(folder.path()) == files);
  CHECK(read_bytes(files.front()) == good);
  check_same(grid.count(sharing), whole);
  CHECK(account.found == 1);
}
