// Numbers between bounds, as a report writes them: what is written encloses what was known.
#include <catch2/catch.hpp>

#include <reports/section/common/words/brackets.hpp>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace pmreport::section;

TEST_CASE("a bracket has the digits that its width allows, its ends rounded outward") {
  CHECK(bracket({0.61238412, 0.61238424}, "m") == "612.3841 … 612.3843 mm");
  CHECK(bracket({0.6123, 0.6127}, "m") == "612.3 … 612.7 mm");
  CHECK(bracket({-0.0021, -0.0019}, "m") == "−2.1 … −1.9 mm");
  CHECK(bracket({0.55, 0.55}, "m") == "550 mm");
  CHECK(bracket({0.5, 0.50001}, "rad") == "28.6478 … 28.6485°");
  CHECK(bracket({}, "m") == "not known");
}

TEST_CASE("what is written of a bracket encloses it, and is at most three of its last units wider") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> size(-3, 4), width(-9, -1), sign(-1, 1);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::copysign(std::pow(10, size(random)), sign(random)), w = std::abs(x) * std::pow(10, width(random));
    CAPTURE(x, w);
    const Bounds b{x, x + w};
    const std::string text = bracket_number(b, 1);
    std::string plain = text;
    for (std::size_t at = 0; (at = plain.find("−", at)) != std::string::npos;) plain.replace(at, std::string("−").size(), "-");
    const std::size_t between = plain.find(" … ");
    REQUIRE(between != std::string::npos);
    const double low = std::strtod(plain.c_str(), nullptr),
                 high = std::strtod(plain.c_str() + between + std::string(" … ").size(), nullptr);
    const std::size_t point = plain.find('.');
    const int decimals = point == std::string::npos || point > between ? 0 : static_cast<int>(between - point) - 1;
    const double unit = std::pow(10, -decimals), rounding = 1e-14 * std::abs(x);
    CHECK(low <= b.low + rounding);
    CHECK(high >= b.high - rounding);
    CHECK(high - low <= b.width() + 2.001 * unit + rounding);
    CHECK((unit <= 1.001 * b.width() || decimals == 0 || std::abs(x) / unit > 0.99e8));
  }
}

TEST_CASE("an instant is told to the decimals that are known, a span rounded outward") {
  CHECK(instant_words({1.2031002, 1.2031009}) == "1.203101 s");
  CHECK(instant_words(Bounds::exactly(10)) == "10 s");
  CHECK(instant_words({3.1, 3.102}) == "3.10 s");
  CHECK(span_words({3.1200004, 3.1399991}) == "from t = 3.12 s to 3.14 s");
  CHECK(span_words({0, 10}) == "from t = 0 s to 10 s");
  CHECK(span_words(Bounds::exactly(2.5)) == "at t = 2.5 s");
}
