// Counts of a grid are those of its poses one by one, however they are counted.
#include <tests/scan/sets.hpp>

#include <tbb/global_control.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace sets;
using scan::count_grid;
using scan::GridCounts;
using scan::GridOptions;

namespace {

// A number that some poses do not have, and one of another sign on either side: |x - 0.5| - 0.25 and a root.
scan::LateMargins late_margins() {
  return {2, [](std::size_t count, const double* poses, double* out) {
            for (std::size_t k = 0; k < count; ++k) {
              const double x = poses[k], turn = poses[4 * count + k];
              out[k] = std::abs(x - 0.5) - 0.25;
              out[count + k] = std::sqrt(turn + 0.5);
            }
          }};
}

}  // namespace

TEST_CASE("a grid is counted as its poses one by one, with and without pruning, reasons, orientations and late margins") {
  constexpr std::uint64_t seed = 71;
  Random random(seed);
  const program::Program sign = plane();
  std::uint64_t accepted = 0, on_a_limit = 0;
  for (int trial = 0; trial < 10; ++trial) {
    scan::PoseSet set = three_legs();
    if (trial % 3 == 2) {
      set.late = late_margins();
      set.rounding.insert(set.rounding.end(), {1e-12, 0.0});
    }
    const scan::Scan s = any_scan(random, trial % 2 == 0);
    GridOptions options;
    options.keep_poses = trial % 4 < 2;
    if (trial % 5 != 0) options.sign = &sign;
    CAPTURE(seed, trial);
    for (const bool reasons : {true, false}) {
      options.reasons = reasons;
      const GridCounts expected = brute_force(set, s, options);
      accepted += expected.tally.accepted, on_a_limit += expected.tally.on_a_limit;
      for (const bool prune : {true, false}) {
        options.prune = prune;
        CAPTURE(reasons, prune, s.point_count(), s.orientation_count());
        check_same(count_grid(set, s, options), expected);
      }
    }
  }
  CHECK(accepted > 3000);
  CHECK(on_a_limit > 100);
}

TEST_CASE("a point has no accepted orientation where one that the others accept fails a margin for every orientation") {
  constexpr std::uint64_t seed = 72;
  Random random(seed);
  scan::PoseSet both = three_legs(), others = both;
  both.late = late_margins();
  both.rounding.insert(both.rounding.end(), {1e-12, 0.0});
  others.late = {1, [judge = late_margins().judge](std::size_t count, const double* poses, double* out) {
                   std::vector<double> all(2 * count);
                   judge(count, poses, all.data());
                   std::copy_n(all.begin(), count, out);
                 }};
  others.rounding.push_back(1e-12);
  std::size_t emptied = 0, kept = 0;
  for (int trial = 0; trial < 8; ++trial) {
    const scan::Scan s = any_scan(random, true);
    const GridCounts alone = brute_force(both, s, {}), before = brute_force(others, s, {});
    scan::PoseSet set = both;
    set.late.every = 1;
    for (const bool reasons : {true, false}) {
      GridOptions options;
      options.reasons = reasons;
      const GridCounts counts = count_grid(set, s, options);
      CAPTURE(seed, trial, reasons);
      CHECK(counts.tally.accepted == alone.tally.accepted);
      CHECK(counts.tally.on_a_limit == alone.tally.on_a_limit);
      if (reasons) CHECK(counts.tally.any == alone.tally.any);
      CHECK((counts.by_others_at == before.accepted_at));
      std::vector<std::uint32_t> expected = alone.accepted_at;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        if (expected[k] < before.accepted_at[k]) expected[k] = 0, ++emptied;
        kept += expected[k] > 0;
      }
      CHECK((counts.accepted_at == expected));
    }
  }
  CHECK(emptied > 100);
  CHECK(kept > 100);
}

TEST_CASE("a large shell is counted alike by one thread and two, with and without pruning") {
  const scan::PoseSet set = shell(0.5, 1.0);
  const scan::Scan s{{0, 0, 0}, {{0, -1.25, 1.25, 101}, {1, 1.25, -1.25, 101}, {2, -1.25, 1.25, 101}}};
  std::uint64_t inside = 0, limit = 0, low = 0, high = 0;
  // In whole steps of 1/40, squares of the radii are 400 and 1600.
  for (int x = -50; x <= 50; ++x)
    for (int y = -50; y <= 50; ++y)
      for (int z = -50; z <= 50; ++z) {
        const int squared = x * x + y * y + z * z;
        inside += squared >= 400 && squared <= 1600;
        limit += squared == 400 || squared == 1600;
        low += squared<400, high += squared> 1600;
      }
  for (const std::size_t threads : {1, 2})
    for (const bool prune : {true, false}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      GridOptions options;
      options.prune = prune;
      const GridCounts counts = count_grid(set, s, options);
      CAPTURE(threads, prune);
      CHECK(counts.tally.poses == 101u * 101u * 101u);
      CHECK(counts.tally.accepted == inside);
      CHECK(counts.tally.on_a_limit == limit);
      CHECK(counts.tally.first == std::vector<std::uint64_t>{0, low, high});
      CHECK(counts.tally.any == counts.tally.first);
      CHECK(counts.low == std::vector<double>{-1, -1, -1});
      CHECK(counts.high == std::vector<double>{1, 1, 1});
      for (const double c : counts.centroid) CHECK(std::abs(c) < 1e-12);  // a mean of half a million numbers below 1
    }
}

TEST_CASE("a grid of orientations alone, and one of a single pose, are counted") {
  const scan::PoseSet set = three_legs();
  scan::Scan s{{0.25, 0.5, 0.875, 0, 0}, {}, {3, 4}, {}};
  Random random(72);
  for (int k = 0; k < 10000; ++k) s.orientations.push_back({random.within(-1, 1), random.within(-3, 3)});
  const GridOptions options;
  const GridCounts expected = brute_force(set, s, options);
  CHECK(expected.tally.accepted > 100);
  CHECK(expected.tally.accepted < 9900);
  check_same(count_grid(set, s, options), expected);
  s.orientations.clear();
  s.turned.clear();
  check_same(count_grid(set, s, options), brute_force(set, s, options));
}

TEST_CASE("nothing is accepted, or everything: no ends, or those of the grid") {
  const scan::Scan s{{0, 0, 0}, {{0, -1, 1, 9}, {1, 1, -1, 9}, {2, 0.5, 0.5, 1}}};
  const GridCounts none = count_grid(shell(4, 5), s, {});
  CHECK(none.tally.accepted == 0);
  CHECK(none.tally.first == std::vector<std::uint64_t>{0, 81, 0});
  CHECK(none.low.empty());
  CHECK(none.centroid.empty());
  const GridCounts all = count_grid(shell(0.25, 5), s, {});
  CHECK(all.tally.accepted == 81);
  CHECK(all.low == std::vector<double>{-1, -1, 0.5});
  CHECK(all.high == std::vector<double>{1, 1, 0.5});
}

TEST_CASE("what cannot be counted is refused with a sentence, before anything is done") {
  const scan::PoseSet set = shell(0.5, 1);
  scan::Scan s{{0, 0, 0}, {{0, -1, 1, std::size_t{1} << 30}, {1, -1, 1, std::size_t{1} << 30}, {2, -1, 1, 9}}};
  CHECK_THROWS_AS(count_grid(set, s, {}), std::length_error);
  CHECK_THROWS_WITH(count_grid(set, s, {}), Catch::Contains("2^53"));
  CHECK_THROWS_AS(scan::memory_needed(set, s, {}), std::length_error);
  s.points[0].count = 0;
  CHECK_THROWS_WITH(count_grid(set, s, {}), Catch::Contains("none"));
  s.points = {{0, -1, 1, 3}, {0, -1, 1, 3}};
  CHECK_THROWS_WITH(count_grid(set, s, {}), Catch::Contains("twice"));
  s.points = {{3, -1, 1, 3}};
  CHECK_THROWS_AS(count_grid(set, s, {}), std::invalid_argument);
  s.points = {{0, -1, 1, 3}};
  s.turned = {1};
  s.orientations = {{0, 0}};
  CHECK_THROWS_WITH(count_grid(set, s, {}), Catch::Contains("orientation"));
  scan::PoseSet short_of_rounding = set;
  short_of_rounding.rounding.pop_back();
  s = {{0, 0, 0}, {{0, -1, 1, 3}}};
  CHECK_THROWS_WITH(count_grid(short_of_rounding, s, {}), Catch::Contains("rounding"));
}

TEST_CASE("memory that is told is no less than what is kept, and seconds are told beforehand") {
  const scan::PoseSet set = three_legs();
  Random random(73);
  const scan::Scan s = any_scan(random, true);
  const program::Program sign = plane();
  GridOptions options;
  options.keep_poses = true;
  options.sign = &sign;
  const GridCounts counts = count_grid(set, s, options);
  const std::size_t kept = counts.accepted_at.size() * 4 + counts.accepted_poses.size() * 8 + counts.positive_poses.size() * 8 +
                           counts.negative_poses.size() * 8;
  CHECK(scan::memory_needed(set, s, options) >= kept);
  CHECK(scan::memory_needed(set, s, options) < 3 * kept);
  const double seconds = scan::seconds_needed(set, s, options);
  CHECK(seconds > 0);
  CHECK(seconds < 10);  // of a hundred thousand poses at most, which take some milliseconds
}

TEST_CASE("a scan is told how far it is, and ends when it is asked to") {
  const scan::PoseSet set = shell(0.5, 1.0);
  const scan::Scan s{{0, 0, 0}, {{0, -1, 1, 64}, {1, -1, 1, 64}, {2, -1, 1, 64}}};
  std::vector<double> shares;
  struct Stop {};
  scan::Watch watch;
  watch.done = [&](double share) { shares.push_back(share); };
  count_grid(set, s, {}, watch);
  REQUIRE(!shares.empty());
  CHECK(std::is_sorted(shares.begin(), shares.end()));
  CHECK(shares.back() == 1);
  watch.stop_if_asked = [] { throw Stop(); };
  CHECK_THROWS_AS(count_grid(set, s, {}, watch), Stop);
}
