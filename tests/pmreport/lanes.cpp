// What lanes compute is what each lane's number computes alone, for every scalar that is made of lanes.
#include <array>
#include <catch2/catch.hpp>
#include <pmreport/jet.hpp>
#include <pmreport/lanes.hpp>
#include <pmreport/partials.hpp>
#include <pmreport/placement.hpp>
#include <tests/pmreport/functions.hpp>
#include <vector>

using namespace pmreport;
using functions::Random;

namespace {

constexpr int lane_tries = 20;
// The lanes' own sine, cosine and the like err by a few units in the last place; second derivatives add up several of them.
constexpr double lane_rounding = 1e-14;

// A scalar as the contract stores it: components of `stride` poses.
template <class T>
std::vector<double> stored(const T& x, std::size_t stride) {
  std::vector<double> out(Codec<T>::components * stride);
  Codec<T>::store(out.data(), stride, x);
  return out;
}

template <class Wide, class Single>
class Both {
 public:
  // The same numbers for both scalars: value within the range, the other components within one.
  Both(Random& random, double min, double max) {
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = i < Lanes::width ? random.within(min, max) : random.within(-1, 1);
  }
  Wide wide() const { return Codec<Wide>::load(numbers_.data(), Lanes::width); }
  Single single(std::size_t lane) const { return Codec<Single>::load(numbers_.data() + lane, Lanes::width); }

 private:
  std::array<double, Codec<Wide>::components * Lanes::width> numbers_;
};

template <class Wide, class Single>
void check_lane(const Wide& wide, const Single& single, std::size_t lane) {
  const auto all = stored(wide, Lanes::width);
  const auto alone = stored(single, 1);
  for (std::size_t c = 0; c < alone.size(); ++c) {
    CAPTURE(lane, c);
    CHECK(all[c * Lanes::width + lane] == Approx(alone[c]).epsilon(lane_rounding).margin(lane_rounding));
  }
}

template <class Wide, class Single>
void check_all_functions(std::uint64_t seed) {
  Random random(seed);
  functions::each_of_one([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < lane_tries; ++i) {
      CAPTURE(name, seed, i);
      const Both<Wide, Single> x(random, min, max);
      for (std::size_t lane = 0; lane < Lanes::width; ++lane) check_lane(Wide(f(x.wide())), f(x.single(lane)), lane);
    }
  });
  functions::each_of_two([&](const char* name, double min, double max, auto f) {
    for (int i = 0; i < lane_tries; ++i) {
      CAPTURE(name, seed, i);
      const Both<Wide, Single> x(random, min, max), y(random, min, max);
      for (std::size_t lane = 0; lane < Lanes::width; ++lane)
        check_lane(Wide(f(x.wide(), y.wide())), f(x.single(lane), y.single(lane)), lane);
    }
  });
}

}  // namespace

TEST_CASE("lanes equal doubles") { check_all_functions<Lanes, double>(4); }
TEST_CASE("jets of lanes equal jets of doubles") { check_all_functions<Jet<Lanes>, Jet<double>>(5); }
TEST_CASE("partials of lanes equal partials of doubles") { check_all_functions<Partials<Lanes, 5>, Partials<double, 5>>(6); }

TEST_CASE("each lane takes its own branch") {
  std::array<double, Lanes::width> a{}, b{};
  for (std::size_t i = 0; i < Lanes::width; ++i) a[i] = i % 2 == 0 ? 1.0 : -1.0, b[i] = 0.5 * double(i) - 0.25;
  const Lanes x = Lanes::load(a.data()), y = Lanes::load(b.data());
  const auto chosen = stored(choose(x < 0.0, x, y), Lanes::width), low = stored(smaller(x, y), Lanes::width),
             high = stored(larger(x, y), Lanes::width), size = stored(abs(x), Lanes::width);
  for (std::size_t i = 0; i < Lanes::width; ++i) {
    CHECK(chosen[i] == (i % 2 == 1 ? a[i] : b[i]));
    CHECK(low[i] == std::min(a[i], b[i]));
    CHECK(high[i] == std::max(a[i], b[i]));
    CHECK(size[i] == 1.0);
  }
}

TEST_CASE("a constant fills all lanes") {
  for (const double x : stored(Lanes(2.5), Lanes::width)) CHECK(x == 2.5);
}
