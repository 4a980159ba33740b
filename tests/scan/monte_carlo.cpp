// Random poses: their numbers are those that were published, and their intervals hold what is known.
#include <tests/scan/sets.hpp>

#include <tbb/global_control.h>
#include <catch2/catch.hpp>
#include <core/program/evaluate.hpp>
#include <core/scan/monte_carlo.hpp>
#include <core/scan/philox.hpp>

#include <array>
#include <cmath>
#include <numbers>

using namespace sets;
using scan::Estimate;
using scan::monte_carlo;
using scan::MonteCarloOptions;

namespace {

using Four = std::array<std::uint32_t, 4>;

MonteCarloOptions options(std::uint64_t poses, std::uint64_t seed, bool reasons = false) { return {poses, seed, reasons}; }

void check_same(const scan::Tally& a, const scan::Tally& b) {
  CHECK(a.poses == b.poses);
  CHECK(a.accepted == b.accepted);
  CHECK(a.on_a_limit == b.on_a_limit);
  CHECK(a.first == b.first);
  CHECK(a.any == b.any);
}

}  // namespace

TEST_CASE("the random numbers are those of Philox4x32-10 that its authors publish") {
  // kat_vectors of Random123.
  CHECK(scan::philox({0, 0, 0, 0}, {0, 0}) == Four{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
  constexpr std::uint32_t ones = 0xffffffff;
  CHECK(scan::philox({ones, ones, ones, ones}, {ones, ones}) == Four{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
  CHECK(scan::philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
        Four{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("the numbers of poses fill the range evenly, and those of axes and seeds have nothing in common") {
  constexpr std::uint64_t n = 100000;
  std::array<int, 20> bins{};
  double axes = 0, seeds = 0, neighbours = 0;
  for (std::uint64_t k = 0; k < n; ++k) {
    const auto u = scan::uniform(5, k, 0), other = scan::uniform(6, k, 0), next = scan::uniform(5, k + 1, 0);
    REQUIRE((u[0] >= 0 && u[0] < 1));
    ++bins[static_cast<std::size_t>(20 * u[0])];
    axes += (u[0] - 0.5) * (u[1] - 0.5);
    seeds += (u[0] - 0.5) * (other[0] - 0.5);
    neighbours += (u[0] - 0.5) * (next[0] - 0.5);
  }
  double chi_squared = 0;
  for (const int b : bins) chi_squared += (b - n / 20.0) * (b - n / 20.0) / (n / 20.0);
  CHECK(chi_squared < 43.8);  // 99.9 % of such sums with 19 degrees of freedom
  // The sums have a standard deviation of sqrt(n) / 12; 4 of them are left in one of 16 000.
  const double most = 4 * std::sqrt(static_cast<double>(n)) / 12;
  CHECK(std::abs(axes) < most);
  CHECK(std::abs(seeds) < most);
  CHECK(std::abs(neighbours) < most);
}

TEST_CASE("the interval of a shell's share holds the true one for about 95 of 100 seeds") {
  const scan::PoseSet set = shell(0.5, 1.0);
  const scan::Scan s{{0, 0, 0}, {{0, -1, 1}, {1, 1, -1}, {2, -1, 1}}};
  const double truth = 4.0 / 3.0 * std::numbers::pi * (1 - 0.125) / 8;
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Estimate e = monte_carlo(set, s, 1, options(5000, seed));
    CHECK(e.tally.poses == 5000);
    CHECK(e.low < e.share);
    CHECK(e.share < e.high);
    held += e.low <= truth && truth <= e.high;
  }
  // Of 200 at 0.95 each, 190 with a standard deviation of 3.1: three of these to either side.
  CHECK(held >= 180);
  CHECK(held <= 199);
}

TEST_CASE("the interval is that of Wilson, and closed at the ends") {
  const scan::Scan s{{0, 0, 0}, {{0, -1, 1}, {1, -1, 1}, {2, -1, 1}}};
  const Estimate none = monte_carlo(shell(4, 5), s, 1, options(1000, 1)), all = monte_carlo(shell(0, 5), s, 1, options(1000, 1));
  CHECK(none.share == 0);
  CHECK(none.low == 0);
  CHECK(none.high == Approx(0.0038267).epsilon(1e-4));  // z^2 / (n + z^2), z = 1.959964
  CHECK(all.high == 1);
  CHECK(all.low == Approx(1 - 0.0038267).epsilon(1e-6));
  // Where p is the end, |seen - p| is z of p's own standard deviations.
  const Estimate e = monte_carlo(shell(0.5, 1), s, 1, options(3000, 9));
  for (const double p : {e.low, e.high})
    CHECK(std::abs(e.share - p) == Approx(1.959963984540054 * std::sqrt(p * (1 - p) / 3000)).epsilon(1e-9));
}

TEST_CASE("random poses are the same for one thread and two, and what refuses them is told") {
  const scan::PoseSet set = three_legs();
  const scan::Scan s{{0, 0, 0, 0.1, 0.2}, {{2, -1.5, 1.5}, {0, 1.5, -1.5}, {1, 0.25, 0.25}}};
  Estimate one, two;
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    one = monte_carlo(set, s, 1, options(50000, 3, true));
  }
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 2);
    two = monte_carlo(set, s, 1, options(50000, 3, true));
  }
  check_same(one.tally, two.tally);
  const Estimate brief = monte_carlo(set, s, 1, options(50000, 3));
  CHECK(brief.tally.accepted == one.tally.accepted);
  CHECK(brief.tally.first.empty());
  CHECK(one.tally.accepted > 100);

  // The same poses, one by one.
  program::Evaluator<double> evaluator(set.margins);
  scan::Tally expected;
  expected.first.assign(set.size(), 0), expected.any.assign(set.size(), 0);
  for (std::uint64_t k = 0; k < 50000; ++k) {
    const auto u = scan::uniform(3, k, 0);
    std::vector<double> q{1.5 + (-1.5 - 1.5) * u[1], 0.25, -1.5 + 3.0 * u[0], 0.1, 0.2}, m(set.size());
    evaluator.run(q, m);
    ++expected.poses;
    bool accepted = true;
    for (std::size_t i = 0; i < m.size() && (i == 0 || m[0] >= 0); ++i)
      if (!(m[i] >= 0)) ++expected.any[i], expected.first[i] += accepted, accepted = false;
    expected.accepted += accepted;
  }
  check_same(one.tally, expected);
}

TEST_CASE("with orientations a point needs so many of them, and is on a limit where rounding decides whether it has") {
  // An orientation is a radius: a point is accepted where x is no more than it.
  const program::Program p = recording::recorded(2, [](const std::vector<Recorded>& q) { return std::vector<Recorded>{q[1] - q[0]}; });
  scan::Scan s{{0, 0}, {{0, 0, 1}}, {1}, {{0.25}, {0.5}, {0.75}}};
  for (std::size_t need = 1; need <= 3; ++need) {
    const Estimate e = monte_carlo({p, {0}, {}}, s, need, options(20000, 11, true));
    CHECK(e.tally.poses == 20000);
    CHECK(std::abs(e.share - (1 - 0.25 * static_cast<double>(need))) < 0.02);  // six standard deviations
    CHECK(e.tally.on_a_limit == 0);
    CHECK(std::abs(static_cast<double>(e.tally.any[0]) / 60000 - 0.5) < 0.02);
  }
  // Rounding of 0.1: with three of three, x from 0.25 - 0.1 to 0.25 + 0.1 is accepted by it.
  const Estimate e = monte_carlo({p, {0.1}, {}}, s, 3, options(20000, 11));
  CHECK(std::abs(e.share - 0.35) < 0.02);
  CHECK(std::abs(static_cast<double>(e.tally.on_a_limit) / 20000 - 0.2) < 0.02);

  CHECK_THROWS_AS(monte_carlo({p, {0}, {}}, s, 0, options(10, 1)), std::invalid_argument);
  CHECK_THROWS_WITH(monte_carlo({p, {0}, {}}, s, 4, options(10, 1)), Catch::Contains("4 of 3"));
  CHECK_THROWS_AS(monte_carlo({p, {0}, {}}, s, 1, options(0, 1)), std::invalid_argument);
}
