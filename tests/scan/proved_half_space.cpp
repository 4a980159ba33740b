// The share of a box that a half-space covers, against whole numbers, which are exact.
#include <catch2/catch.hpp>
#include <core/scan/proof/half_space.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace pmreport::scan;
using pmreport::program::Bounds;

namespace {

__extension__ using Whole = __int128;

// Of whole c and weights: the share is numerator / denominator, with t = (c + sum |w|) / 2,
//     sum over subsets S of (-1)^|S| max(0, c + sum |w| - 2 sum of |w| in S)^d / (2^d d! prod |w|).
struct Share {
  Whole numerator = 0, denominator = 1;
};
Share share(int c, const std::vector<int>& w) {
  Whole sum = c;
  for (const int x : w) sum += std::abs(x);
  Share out;
  for (unsigned subset = 0; subset < 1u << w.size(); ++subset) {
    Whole rest = sum, term = 1;
    for (std::size_t k = 0; k < w.size(); ++k)
      if (subset >> k & 1) rest -= 2 * std::abs(w[k]), term = -term;
    if (rest <= 0) continue;
    for (std::size_t k = 0; k < w.size(); ++k) term *= rest;
    out.numerator += term;
  }
  for (std::size_t k = 0; k < w.size(); ++k) out.denominator *= 2 * std::abs(w[k]) * static_cast<int>(k + 1);
  return out;
}

// bound < share, or less: by whole numbers, bound = m 2^e with m below 2^53. The numbers are below 2^62, so the products fit.
int compare(double bound, const Share& s) {
  int exponent = 0;
  const auto m = static_cast<Whole>(std::ldexp(std::frexp(bound, &exponent), 53));
  exponent -= 53;
  Whole left = m * s.denominator, right = s.numerator;  // left 2^exponent against right
  while (exponent < 0 && right < (Whole{1} << 124)) right *= 2, ++exponent;
  if (exponent < 0) return -1;  // right is beyond all that left could be
  return left < right ? -1 : left > right ? 1 : 0;
}

}  // namespace

TEST_CASE("The bounds of a half-space's share hold the fraction that it is, to the last bit: turned inward they do not") {
  std::mt19937_64 random(20);
  std::size_t inexact = 0, found_out = 0, narrow = 0, trials = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<int> w(1 + trial % 6);
    int sum = 0;
    for (int& x : w) x = static_cast<int>(random() % 2 ? 1 : -1) * static_cast<int>(1 + random() % 24), sum += std::abs(x);
    const int c = static_cast<int>(random() % static_cast<unsigned>(2 * sum)) - sum;
    const std::vector<double> weights(w.begin(), w.end());
    const Bounds found = half_space_share(Bounds::exactly(c), weights);
    const Share truth = share(c, w);
    CAPTURE(trial, c, w, found.low, found.high);
    CHECK(compare(found.low, truth) <= 0);
    CHECK(compare(found.high, truth) >= 0);
    if (found.low < found.high) {
      ++inexact;
      found_out += compare(found.high, truth) > 0 || compare(found.low, truth) < 0;  // as a low end; as a high end
    }
    ++trials;
    narrow += found.width() < 1e-9;
  }
  CHECK(found_out == inexact);
  CHECK(inexact > trials / 2);
  CHECK(narrow > trials * 9 / 10);  // the others have weights that are left out
}

TEST_CASE("Weights that are small beside the largest cost little, and the bounds still hold a count") {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<double> w(2 + trial % 5);
    for (double& x : w) x = std::exp2(-30 * std::abs(any(random)));
    w[0] = 1;
    if (trial % 3 == 0) w[1] = 0;
    const double c = 1.2 * any(random);
    const Bounds found = half_space_share(Bounds::exactly(c), w);
    constexpr int poses = 4000;
    int counted = 0;
    for (int k = 0; k < poses; ++k) {
      double g = c;
      for (const double x : w) g += x * any(random);
      counted += g >= 0;
    }
    const double share = double(counted) / poses, slack = 5 * std::sqrt(0.25 / poses);
    CAPTURE(trial, c, w, share, found.low, found.high);
    CHECK(found.low - slack <= share);
    CHECK(share <= found.high + slack);
    CHECK(found.width() < 0.05);
  }
}

TEST_CASE("Half-spaces without a slope cover all or nothing") {
  CHECK(half_space_share({-1, 1}, {}) == Bounds{0, 1});
  CHECK(half_space_share({0, 0}, std::vector<double>{0, 0}) == Bounds{1, 1});
  CHECK(half_space_share({-2, -1}, std::vector<double>{0.4, 0.4}) == Bounds{0, 0});
  CHECK(half_space_share({1, 2}, std::vector<double>{0.4, -0.4}) == Bounds{1, 1});
}
