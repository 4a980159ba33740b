#include "reports/figure/layout/axis.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace pmreport::figure;

namespace {

std::vector<std::string> labels(const Scale& scale) {
  std::vector<std::string> texts;
  for (const Tick& tick : scale.major) texts.push_back(tick.label);
  return texts;
}

using Values = std::vector<double>;
using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("ticks are round and cover their range") {
  // Exact comparison: a tick is the double nearest to its decimal, as the compiler reads it.
  CHECK(ticks(0, 10, 6) == Values{0, 2, 4, 6, 8, 10});
  CHECK(ticks(0, 1, 5) == Values{0, 0.25, 0.5, 0.75, 1});
  CHECK(ticks(-0.3, 0.3, 7) == Values{-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3});
  CHECK(ticks(591, 664, 5) == Values{575, 600, 625, 650, 675});
  CHECK(ticks(0, 3e-6, 4) == Values{0, 1e-6, 2e-6, 3e-6});
  CHECK(ticks(-2e7, 2e7, 5) == Values{-2e7, -1e7, 0, 1e7, 2e7});
  CHECK(ticks(10, 0, 6) == ticks(0, 10, 6));
}

TEST_CASE("random ranges get a handful of evenly spaced ticks with round steps") {
  std::mt19937_64 random(20240607);
  std::uniform_real_distribution<double> exponent(-9, 9), fraction(-1, 1);
  std::uniform_int_distribution<int> count(3, 9);
  for (int i = 0; i < 2000; ++i) {
    const double width = std::pow(10, exponent(random)), low = 30 * width * fraction(random), high = low + width;
    const int wanted = count(random);
    CAPTURE(low, high, wanted);
    const std::vector<double> values = ticks(low, high, wanted);
    REQUIRE(values.size() >= 2);
    // A step may be 2.5 times too small or too large, and an outer tick may be added on both sides.
    CHECK(values.size() <= 2 * static_cast<std::size_t>(wanted) + 2);
    const double step = values[1] - values[0];
    // 1e-9 steps: a tick at an end of the range may miss it by rounding.
    CHECK(values.front() <= low + 1e-9 * step);
    CHECK(values.back() >= high - 1e-9 * step);
    CHECK(values.front() > low - step);
    CHECK(values.back() < high + step);
    const double mantissa = step / std::pow(10, std::floor(std::log10(step) + 1e-9));
    const bool round =
        std::abs(mantissa - 1) < 1e-6 || std::abs(mantissa - 2) < 1e-6 || std::abs(mantissa - 2.5) < 1e-6 || std::abs(mantissa - 5) < 1e-6;
    CHECK(round);
  }
}

TEST_CASE("ticks survive ranges that are no ranges") {
  for (const auto& [low, high] :
       {std::pair{0.0, 0.0}, {5.0, 5.0}, {NAN, 1.0}, {0.0, INFINITY}, {-1e308, 1e308}, {1e300, 1e300}, {0.0, 1e-320}}) {
    CAPTURE(low, high);
    const std::vector<double> values = ticks(low, high, 5);
    CHECK(values.size() >= 2);
    CHECK(values.size() < 20);
    for (const double value : values) CHECK(std::isfinite(value));
  }
}

TEST_CASE("tick labels have equal decimals, a typographic minus and no negative zero") {
  CHECK(labels(make_scale(-5, 5, 5)) == Words{"−5.0", "−2.5", "0.0", "2.5", "5.0"});
  CHECK(labels(make_scale(-0.2, 0.2, 5)) == Words{"−0.2", "−0.1", "0.0", "0.1", "0.2"});
  CHECK(labels(make_scale(0, 10, 6)) == Words{"0", "2", "4", "6", "8", "10"});
  CHECK(labels(make_scale(0.5, 9.7, 6)) == Words{"2", "4", "6", "8"});
}

TEST_CASE("a power of ten common to all labels stands once at the axis") {
  const Axis force{"force", "N"};
  const Scale large = make_scale(0, 30000, 4);
  CHECK(labels(large) == Words{"0", "10", "20", "30"});
  CHECK(axis_title(force, large) == "force [10³ N]");
  const Scale small = make_scale(0, 3e-8, 4);
  CHECK(labels(small) == Words{"0", "10", "20", "30"});
  CHECK(axis_title(force, small) == "force [10⁻⁹ N]");
  CHECK(axis_title(force, make_scale(0, 9000, 4)) == "force [N]");
  CHECK(axis_title({"condition number", ""}, large) == "condition number [10³]");
  CHECK(axis_title({"condition number", ""}, make_scale(1, 4, 4)) == "condition number");
  CHECK(axis_title({"", ""}, make_scale(1, 4, 4)).empty());
}

TEST_CASE("a tiny variation of a large value is counted from an offset") {
  const Scale scale = make_scale(812.4 - 3e-6, 812.4 + 3e-6, 4);
  CHECK(axis_title({"length", "mm"}, scale) == "length − 812.4 [10⁻⁶ mm]");
  CHECK(labels(scale) == Words{"−2", "0", "2"});
  CHECK(axis_title({"height", "m"}, make_scale(-100.00002, -99.99998, 4)) == "height + 100 [10⁻⁶ m]");
  CHECK(make_scale(590, 664, 5).offset == 0);
}

TEST_CASE("numbers are set as an author would set them") {
  CHECK(typeset(-812.4) == "−812.4");
  CHECK(typeset(312345.0, 2) == "3.1×10⁵");
  CHECK(typeset(-2.5e-7) == "−2.5×10⁻⁷");
  CHECK(typeset(0) == "0");
}
