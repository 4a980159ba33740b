// The share of a box that a half-space covers, against sums in extended precision and counting.
#include <catch2/catch.hpp>
#include <core/scan/proof/half_space.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace pmreport::scan;
using pmreport::program::Bounds;

namespace {

// The share where c + w.x >= 0 in closed form: once more, but by integrating one axis after the other. F_1 is linear between its kinks; the
// mean over a further axis of a piecewise polynomial is that of its integral. Written here as repeated differences of (max(0, t))^d with
// the largest weights first, in long double, for weights that are no smaller than a hundredth of the largest.
long double share(long double c, const std::vector<double>& w) {
  long double sum = 0, product = 1;
  for (const double x : w) sum += std::abs(x);
  const long double t = (c + sum) / 2;
  long double total = 0;
  for (unsigned subset = 0; subset < 1u << w.size(); ++subset) {
    long double rest = t;
    int sign = 1;
    for (std::size_t k = 0; k < w.size(); ++k)
      if (subset >> k & 1) rest -= std::abs(w[k]), sign = -sign;
    if (rest > 0) total += sign * std::pow(rest, static_cast<long double>(w.size()));
  }
  for (std::size_t k = 0; k < w.size(); ++k) product *= std::abs(static_cast<long double>(w[k])) * static_cast<long double>(k + 1);
  return std::clamp(total / product, 0.0L, 1.0L);
}

}  // namespace

TEST_CASE("The bounds of a half-space's share hold what extended precision gives, and are narrow") {
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<double> w(1 + trial % 6);
    for (double& x : w) x = std::copysign(0.1 + 0.9 * std::abs(any(random)), any(random));
    double sum = 0;
    for (const double x : w) sum += std::abs(x);
    const double c = 1.1 * sum * any(random);
    const long double truth = share(c, w);
    const Bounds found = half_space_share(Bounds::exactly(c), w);
    CAPTURE(trial, c, w, static_cast<double>(truth), found.low, found.high);
    // Terms of (1.9 / 2)^6 / (720 1e-5) cancel at most, in 64 terms of 2^-64 each.
    const long double of_the_sum = 1e-14L;
    CHECK(found.low <= truth + of_the_sum);
    CHECK(truth - of_the_sum <= found.high);
    CHECK(found.width() < 1e-9);
  }
}
